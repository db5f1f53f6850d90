from setuptools import find_packages
from setuptools import setup

NAME = "ament_bringup_lint"

setup(
    name=NAME,
    version="0.1.0",
    packages=find_packages(exclude=["test"]),
    data_files=[
        (f"share/{NAME}", ["package.xml"]),
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
    ],
    install_requires=["setuptools"],
    extras_require={"test": ["pytest"]},
    zip_safe=True,
    maintainer="bringup-lint",
    maintainer_email="bringup-lint@users.noreply.github.com",
    description="Checks how a robot comes up with bringup-lint, and writes the result as xunit.",
    license="Apache-2.0",
    entry_points={
        "console_scripts": [f"{NAME} = {NAME}.main:main"],
        "pytest11": [f"{NAME} = {NAME}.pytest_marker"],
    },
)
