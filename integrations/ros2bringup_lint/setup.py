from setuptools import find_packages
from setuptools import setup

NAME = "ros2bringup_lint"

setup(
    name=NAME,
    version="0.1.0",
    packages=find_packages(exclude=["test"]),
    data_files=[
        (f"share/{NAME}", ["package.xml"]),
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
    ],
    install_requires=["ros2cli"],
    zip_safe=True,
    maintainer="bringup-lint",
    maintainer_email="bringup-lint@users.noreply.github.com",
    description="The command bringup-lint of ros2.",
    license="Apache-2.0",
    entry_points={"ros2cli.command": [f"bringup-lint = {NAME}.command.bringup_lint:BringupLintCommand"]},
)
