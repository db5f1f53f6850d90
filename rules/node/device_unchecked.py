"""A driver goes on with a device that it could not open.

## What it finds
In C++ sources of nodes and drivers, the result of functions that open a device or a file (`gpiod_chip_open_by_name`,
`gpiod_chip_get_line`, `hid_open`, `fopen`, `opendir`; `open`, `wiringPiI2CSetup`, `serialOpen`, `lgGpiochipOpen`,
`pigpio_start`), kept under a name that the file uses, and neither compares nor returns anywhere. Where the failure is a
negative number, calls whose own result is asked for count as a check. It is an info where each use is in a branch that
a flag for debugging, logs, records or tests decides about, by its name. Also a serial port of LibSerial or `serial`
that is opened in a `try`, whose handler only logs, and that is set up or used below in each case.

## Why it matters on a robot
The device is not there, belongs to another group, or is busy: the usual first start on a new robot. With NULL the next
call ends the node with a segmentation fault that names no device. With -1 each read and write fails, and nothing says
so: the button never reacts, and the sensor reads the same number forever.

## Bad
```cpp
chip_ = gpiod_chip_open_by_name("gpiochip0");
line_ = gpiod_chip_get_line(chip_, 13);
```

## Good
```cpp
chip_ = gpiod_chip_open_by_name("gpiochip0");
if (chip_ == nullptr) { throw std::system_error(errno, std::generic_category(), "gpiochip0"); }
```

## When to ignore it
When something before has made sure that the device can be opened.

## References
- libgpiod, gpiod.h: "or NULL if an error occurred"
- open(2), fopen(3)
- LibSerial, SerialPort.h: `NotOpen`; serial, serial.h: `PortNotOpenedException`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="a segmentation fault names no device, and nobody prints the number that is no descriptor")
def device_unchecked(robot: Robot) -> Iterator[Finding]:
    for found in nodes.unchecked_devices(robot.nodes):
        end = f"NULL, and the next call with {found.name} ends the node with a segmentation fault"
        if not found.is_pointer:
            end = f"a negative number, each call with {found.name} fails, and nothing says so"
        test = f"if ({found.name} {'== nullptr' if found.is_pointer else '< 0'})"
        yield finding(
            found.opened,
            f"When it cannot be opened, {found.function}() returns {end}",
            advice=f"write {test} below, and report errno with the name of what was to be opened",
            related=[note(found.used, "used here")],
            severity="info" if found.is_optional else robot.nodes.lowered_if_vendored(found.opened.source, "warning"),
        )
    for driver in robot.nodes.drivers:
        for port in driver.shut_ports:
            yield finding(
                port.handled,
                f"When {port.name} cannot be opened, this only logs, and the next call with it throws outside the try",
                advice="return an error here, or throw the exception on",
                related=[note(port.opened, "opened here"), note(port.used, "throws when it is not open")],
                severity=robot.nodes.lowered_if_vendored(driver.source, "warning"),
            )
