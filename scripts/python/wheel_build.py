"""What setuptools needs to know beyond pyproject.toml: the wheel carries the shared library, the command, and the tables.

`make` builds them with what this machine has: FLINT where it is installed; without GSL or libconfig the command has no scenes,
no formula files and nothing that needs FLINT, and works all the same. SCALLOP_BUILD names a folder where they are built already."""

import glob
import json
import os
import re
import shutil
import subprocess

from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70
    from wheel.bdist_wheel import bdist_wheel

def defined(name):
    with open("model/version.h", encoding="utf-8") as header:  # setuptools works in the folder of pyproject.toml
        return re.search(rf'^#define {name} "?(.*?)"?$', header.read(), re.MULTILINE)[1]


VERSION, ABI = defined("SCALLOP_VERSION"), int(defined("SCALLOP_ABI"))


def choices():
    """The choices of config.mk that fit what is installed: scripts/dev/setup.sh knows how to tell."""
    said = subprocess.run(["sh", "scripts/dev/setup.sh", "--missing", "all"], stdout=subprocess.PIPE, check=True)
    missing = said.stdout.decode().split()
    given = {name: os.environ.get(name) for name in ("WITH_FLINT", "WITH_GSL", "WITH_LIBCONFIG")}
    found = {"WITH_FLINT": not {"libgmp-dev", "libflint-dev", "libflint-arb-dev"} & set(missing),
             "WITH_GSL": "libgsl-dev" not in missing, "WITH_LIBCONFIG": "libconfig-dev" not in missing}
    return {name: given[name] or str(int(there)) for name, there in found.items()}


def make(folder):
    """Builds library and command in this folder."""
    chosen = choices()
    flint = chosen["WITH_FLINT"] if "0" not in (chosen["WITH_GSL"], chosen["WITH_LIBCONFIG"]) else "0"  # of the command
    if flint == "0" and os.path.exists(f"{folder}/scallop-flint.so"):  # of an earlier build
        os.remove(f"{folder}/scallop-flint.so")
    environment = {"CFLAGS": "-O2", **os.environ}
    for name in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL"):
        environment.pop(name, None)
    for goal, with_flint in (("scallop", flint), ("libscallop.a", chosen["WITH_FLINT"])):
        options = {**chosen, "WITH_FLINT": with_flint, "B": folder}
        subprocess.run(["make", *(f"{name}={value}" for name, value in options.items()), f"{folder}/{goal}"], env=environment,
                       check=True)


def built():
    """Where library and command are"""
    folder = os.environ.get("SCALLOP_BUILD", "")
    if not folder:
        folder = "build/wheel"
        make(folder)
    return folder


class Build(build_py):
    """The package, with library and tables within, and the command beside."""

    def run(self):
        package = os.path.join(self.build_lib, "crawling_scallop")
        for folder in ("lib", "data"):  # of an earlier build
            shutil.rmtree(os.path.join(package, folder), ignore_errors=True)
        super().run()
        folder = built()
        program, part = f"{folder}/scallop", f"{folder}/scallop-flint.so"
        self.put(package, "lib", [f"{folder}/libscallop.so.{ABI}"])
        self.put(package, "data", [*glob.glob("data/*.tsv"), "asymptotics/published/paper.cfg"])
        with open(os.path.join(package, "installed.json"), "w", encoding="utf-8") as file:
            json.dump({"version": VERSION, "abi": ABI, "libraries": "lib", "data": "data",
                       "command": ["../../../../bin/scallop", "../bin/scallop"]}, file)  # of a prefix; of pip install --target
        # The program looks for its part in ../lib/scallop, as make install puts it
        self.distribution.data_files = [("bin", [program])] + ([("lib/scallop", [part])] if os.path.exists(part) else [])

    def put(self, package, folder, files):
        self.mkpath(os.path.join(package, folder))
        for file in files:
            self.copy_file(os.path.realpath(file), os.path.join(package, folder, os.path.basename(file)))


class Wheel(bdist_wheel):
    """For any Python 3 of this platform: the library is called by ctypes."""

    def initialize_options(self):
        super().initialize_options()
        self.distribution.has_ext_modules = lambda: True

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


class Sources(sdist):
    """All that git has, and not only what setuptools thinks that Python needs"""

    def make_distribution(self):
        listed = subprocess.run(["git", "ls-files"], stdout=subprocess.PIPE, check=True).stdout.decode().splitlines()
        self.filelist.extend(listed)
        self.filelist.remove_duplicates()
        super().make_distribution()
