"""A ROS package in source: what package.xml, setup.py, setup.cfg and CMakeLists.txt say about it."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span


@dataclass(eq=False, slots=True)
class Manifest:
    """A package.xml."""

    source: Source
    name: Located | None = None
    build_type: str = ""
    """``ament_cmake``, ``ament_python``, ``catkin``, ... as exported or guessed from the build tool."""
    depends: list[tuple[str, Located]] = field(default_factory=list)
    """Tag (``depend``, ``exec_depend``, ...) and package."""
    places: dict[str, Span] = field(default_factory=dict)
    """Tag -> the last dependency with it."""
    first: Span | None = None
    """The first dependency that is more than a build tool."""
    format: int = 1
    """Of the manifest: the first one has ``run_depend`` and no ``exec_depend``."""
    exported_type: Located | None = None
    """The build type as it is exported, in any condition."""
    export: Span | None = None
    """The start tag of ``<export>``."""
    for_both: bool = False
    """Conditions on ROS_VERSION make it a package of ROS 1 as well."""
    people: list[str] = field(default_factory=list)
    """The names and addresses of maintainers and authors."""
    repositories: list[str] = field(default_factory=list)
    """The addresses that it gives of itself: website, repository, tracker."""
    problems: list[Problem] = field(default_factory=list)
    refused: list[Problem] = field(default_factory=list)
    """What stops catkin_pkg, in order."""
    exported_depends: list[Located] = field(default_factory=list)
    """Packages of dependencies in ``<export>``, which nobody reads."""
    near_build_type: Located | None = None
    """A tag in ``<export>`` that is nearly ``build_type``, where there is none."""

    @property
    def tag_at_runtime(self) -> str:
        """What declares that a package is needed when nodes run."""
        is_first = self.format == 1 and not {"exec_depend", "depend"} & set(self.places)
        return "run_depend" if is_first else "exec_depend"

    @property
    def is_ros1(self) -> bool:
        return self.build_type in ("catkin", "cmake-catkin")


class Install(NamedTuple):
    """Files that the build installs."""

    destination: str
    """Below the install prefix, e.g. ``share/my_robot/launch``."""
    source: str
    """Relative to the package; a glob for files; a folder when ``tree`` (its content when it ends with ``/``)."""
    tree: bool
    where: Span
    filtered: bool = False
    """Patterns decide what of a folder is installed."""
    renamed: str = ""
    """The name that a single file is installed under."""
    sure: bool = False
    """The build ends when it is missing: no condition, and not ``OPTIONAL``."""


class Packages(NamedTuple):
    """The Python packages that setuptools installs."""

    where: Span
    names: tuple[str, ...] | None
    """As they are listed; None for those that ``find_packages`` finds, folders with an ``__init__.py`` each."""


@dataclass(eq=False, slots=True)
class Build:
    """What a build description installs. ``..._known``: everything of it was understood."""

    source: Source
    installs: list[Install] = field(default_factory=list)
    installs_known: bool = True
    executables: dict[str, Located] = field(default_factory=dict)
    """What ``ros2 run`` finds, by name."""
    entry_points: dict[str, str] = field(default_factory=dict)
    """Console script -> ``package.module:function``."""
    scripts_folder: Located | None = None
    """Where setup.cfg puts console scripts, e.g. ``$base/lib/my_robot``; None when it does not say."""
    scripts_folder_known: bool = True
    executables_known: bool = True
    built: dict[str, Located] = field(default_factory=dict)
    """Programs that CMake makes, whether they are installed or not, by the place where they are named."""
    elsewhere: dict[str, Located] = field(default_factory=dict)
    """Targets that are installed where ``ros2 run`` does not look, by the place where the installation names them."""
    unplaced: set[str] = field(default_factory=set)
    """Those of them whose installation says no folder, for which CMake takes `bin` and `lib`."""
    programs_at: Located | None = None
    """The first target that is installed where ``ros2 run`` looks."""
    without_mode: dict[str, Located] = field(default_factory=dict)
    """Programs of ``install(FILES)``, which takes the executable bit away, by the place of the file."""
    python_packages: Packages | None = None
    """What ``packages`` of ``setup()`` names; None when it is not known."""
    listed_packages: Packages | None = None
    """The same, also where ``package_dir`` says that they come from other folders."""
    package_folders: dict[str, Located] = field(default_factory=dict)
    """``package_dir``: Python package, or the empty text for all, -> folder."""
    names_computed: bool = False
    """Names of targets are put together from variables that are not known."""
    installs_python: bool = False
    """CMake installs a Python package, with the scripts of the setup.cfg beside it."""
    interfaces: list[Located] | None = None
    """The words of ``rosidl_generate_interfaces`` behind the target; None when one of them is not known."""
    plugins: list[Located] = field(default_factory=list)
    """Component classes that are registered."""
    plugins_known: bool = True
    targets: dict[str, list[str]] = field(default_factory=dict)
    """The source files of executables and libraries, relative to the folder, as far as they are known."""
    open_targets: set[str] = field(default_factory=set)
    """Executables and libraries some of whose sources are not known."""
    libraries: dict[str, Located] = field(default_factory=dict)
    """Libraries, by the place where they are named."""
    output_names: dict[str, Located] = field(default_factory=dict)
    """Target -> the name of its file, where ``OUTPUT_NAME`` gives it another one."""
    links: dict[str, list[str]] = field(default_factory=dict)
    """What targets link."""
    components: dict[str, str] = field(default_factory=dict)
    """Component class, or the executable that is made for it, -> the library that holds it."""
    main_plugins: dict[str, str] = field(default_factory=dict)
    """Executable that is made for a component -> its class."""
    subdirectories: list[str] = field(default_factory=list)
