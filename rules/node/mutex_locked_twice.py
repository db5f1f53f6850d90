"""A thread locks a mutex that it holds already, and waits for itself.

## What it finds
In C++ a `std::lock_guard`, `std::unique_lock` or `std::scoped_lock` of a mutex, below which the same block calls a
method of the class that locks the same mutex in each case, itself or through another one. In Python the same for `with
self.lock:` where the lock is a `threading.Lock`. Recursive mutexes and `threading.RLock` are left out, and so are calls
after `unlock()`, and lambdas, which run later.

## Why it matters on a robot
A mutex that is not recursive does not know that its owner asks: the thread waits until somebody unlocks it, which only
the thread itself could do. Every other thread that wants the mutex stops there too. The process stays alive, so neither
launch nor systemd starts it again, and it ignores its commands from then on.

## Bad
```cpp
void finish() { std::lock_guard<std::mutex> lock(mutex_); goal_.reset(); }
void start(Goal goal) {
  std::lock_guard<std::mutex> lock(mutex_);
  if (goal_) { finish(); }
}
```

## Good
```cpp
void start(Goal goal) {
  bool is_busy;
  { std::lock_guard<std::mutex> lock(mutex_); is_busy = goal_ != nullptr; }
  if (is_busy) { finish(); }
}
```

## When to ignore it
When the path that leads to the second lock can never be taken.

## References
- https://en.cppreference.com/w/cpp/thread/mutex/lock: the owner must not lock a `std::mutex` again
- https://docs.python.org/3/library/threading.html#lock-objects
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", silent="the thread waits in pthread_mutex_lock, and logs nothing", tags=["CWE-833"])
def mutex_locked_twice(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.relocks(robot.nodes):
        yield finding(
            first.place,
            _message(first.mutex, first.through),
            advice=_advice(first.through, "std::recursive_mutex"),
            related=[
                note(first.held, "locked here"),
                *([note(first.again, "locked here again")] if first.through is not None else []),
                *(note(each.place, "the same here") for each in others),
            ],
            severity=robot.nodes.lowered_if_vendored(first.place.source, "error"),
        )
    for top, *more in nodes.python_relocks(robot.nodes):
        file = top.file
        yield finding(
            file.span_of(top.place),
            _message(top.lock, top.through),
            advice=_advice(top.through, "threading.RLock"),
            related=[
                note(file.span_of(top.held), "locked here"),
                *([note(file.span_of(top.again), "locked here again")] if top.through is not None else []),
                *(note(file.span_of(each.place), "the same here") for each in more),
            ],
            severity=robot.nodes.lowered_if_vendored(file.source, "error"),
        )


def _message(mutex: str, through: str | None) -> str:
    what = f"{through}() locks {mutex}" if through is not None else f"This locks {mutex} again"
    return f"{what}, which this thread holds already: it waits for itself forever"


def _advice(through: str | None, recursive: str) -> str:
    where = f"call {through}() after the lock is given back" if through is not None else "lock it once"
    return f"{where}, or make it a {recursive}"
