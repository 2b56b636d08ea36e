"""What `cmake --install` and CPack make of this build: it runs from any place, and the package says what it needs."""

import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import caselib

BUILD = Path(os.environ["SWELLFLOW_BUILD"])
SOURCES = Path(__file__).resolve().parents[2]
AS_A_USER = {name: value for name, value in caselib.mpi_environment().items() if name not in ("SWELLFLOW_PROGRAM", "PYTHONPATH")}
CHANNEL = ("channel", "-var", "cells", "16", "--check")                       # the fluid alone, a second
CAVITY = ("cavity_swelling", "--np", "2", "-var", "t_end", "0.01")            # objects in it


def call(*command, folder=None):
    return subprocess.run([str(word) for word in command], cwd=folder, env=AS_A_USER, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120)


def files(tree):
    return sorted(str(path.relative_to(tree)) for path in tree.rglob("*"))


class InstalledTest(unittest.TestCase):
    """`tree` is made once, in a scratch folder, and users work in another one."""

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="swellflow_")
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = Path(scratch.name)
        cls.tree = cls.make(cls.scratch)

    @classmethod
    def output(cls, *command, folder=None):
        result = call(*command, folder=folder)
        if result.returncode:
            raise AssertionError(f"{command} gave {result.returncode}:\n{result.stdout[-2000:]}{result.stderr[-2000:]}")
        return result.stdout

    def work_in(self, name):
        folder = self.scratch / name
        folder.mkdir()
        return folder

    def run_cases(self, folder):
        """Results come where the user works, and nothing into the tree."""
        before = files(self.tree)
        case = self.tree / "bin" / "swellflow-case"
        self.assertRegex(self.output(case, *CHANNEL, folder=folder), r"all conditions hold; steady profile: .* = 0\.00\d+\n$")
        self.output(case, *CAVITY, folder=folder)
        self.assertEqual(caselib.read_thermo(folder / "results" / "cavity_swelling" / "log.liggghts")[-1]["Step"], 10)
        self.assertEqual(files(self.tree), before)


class Tree(InstalledTest):
    @classmethod
    def make(cls, scratch):
        first, moved = scratch / "first", scratch / "moved" / "elsewhere"
        cls.output("cmake", "--install", BUILD, "--prefix", first)
        moved.parent.mkdir()
        return first.rename(moved)

    def test_cases_run_where_the_tree_was_moved(self):
        self.run_cases(self.work_in("user"))

    def test_a_script_of_ones_own(self):
        folder = self.work_in("own")
        (folder / "in.own").write_text('print "hello"\n')
        self.assertIn("hello", self.output("mpirun", "-np", "1", self.tree / "bin" / "swellflow", "-in", "in.own", folder=folder))

    def test_the_runner_speaks_of_itself(self):
        case = self.tree / "share" / "swellflow" / "cases" / "run"
        self.assertIn("swellflow-case NAME", self.output(case, folder=self.scratch))
        self.assertIn("swellflow-case: unknown case 'no'", call(case, "no").stderr)
        program = self.tree / "bin" / "swellflow"
        away = program.rename(self.tree / "away")
        missing = call(case, *CHANNEL, folder=self.scratch)
        away.rename(program)
        self.assertIn("swellflow-case: no program swellflow", missing.stderr)
        self.assertNotIn("bootstrap", missing.stderr)

    def test_a_folder_that_cannot_be_made(self):
        folder = self.work_in("blocked")
        (folder / "results").write_text("a file")
        result = call(self.tree / "bin" / "swellflow-case", *CHANNEL, folder=folder)
        self.assertRegex(result.stderr, r"^swellflow-case: .*/results/channel cannot be made \(Not a directory\): name another folder with --out\n$")

    def test_links_between_pages_hold(self):
        root = self.tree / "share" / "doc" / "swellflow"
        pages = [*root.glob("*.md"), *root.glob("docs/**/*.md")]
        self.assertGreater(len(pages), 10)
        for page in pages:
            for target in re.findall(r"\]\(([^)#]+)", page.read_text()):
                if "://" not in target:
                    self.assertTrue((page.parent / target).exists(), f"{page.name}: {target}")

    def test_the_licence(self):
        self.assertEqual((self.tree / "share/doc/swellflow/LICENSE").read_text(), (SOURCES / "LICENSE").read_text())
        self.assertIn("GPL-2.0-or-later", (self.tree / "share/doc/swellflow/copyright").read_text())

    def page(self, name):
        """Of the manual, without its marks."""
        return re.sub(r"\\f[BIR]", "", (self.tree / "share" / "man" / "man1" / f"{name}.1").read_text().replace("\\-", "-"))

    def test_the_manual_page(self):
        text = self.page("swellflow")
        help_text = call(self.tree / "bin" / "swellflow", "-help", folder=self.scratch).stdout
        options = re.findall(r"^ *(--?\w+)[^:\n]*: ", help_text.partition("Style options")[0], re.M)
        self.assertGreater(len(options), 10)
        for option in options:
            self.assertRegex(text, rf"(?m)^\.BR? .*{option}\b")
        for heading in ("OPTIONS", "SIGNALS", "EXIT STATUS", "FILES"):
            self.assertIn(f".SH {heading}\n", text)
        for signal in ("SIGINT", "SIGTERM", "SIGUSR1"):
            self.assertIn(signal, text)

    def test_the_runners_manual_page(self):
        text, help_text = self.page("swellflow-case"), self.output(self.tree / "bin" / "swellflow-case")
        for option in re.findall(r"\[(--?\w+)", help_text.splitlines()[0]):
            self.assertRegex(text, rf"(?m)^\.BI? {option}\b")

    def test_one_version(self):
        version = re.search(r"^swellflow (\S+)", self.output(self.tree / "bin" / "swellflow", "--version")).group(1)
        for name in ("swellflow", "swellflow-case"):
            self.assertIn(f'"swellflow {version}"', self.page(name).splitlines()[0])
        self.assertIn(f"## {version}", (self.tree / "share/doc/swellflow/CHANGELOG.md").read_text())


class Package(InstalledTest):
    """Taken apart by dpkg-deb, which any user can do; tests/debian_package.sh installs it."""

    @classmethod
    def make(cls, scratch):
        cls.output("cpack", "-G", "DEB", "-B", scratch / "made", "--config", BUILD / "CPackConfig.cmake")
        [cls.package] = (scratch / "made").glob("*.deb")
        cls.output("dpkg-deb", "-x", cls.package, scratch / "root")
        return scratch / "root" / "usr"

    def field(self, name):
        return self.output("dpkg-deb", "-f", self.package, name).strip()

    def test_cases_run_from_it(self):
        self.run_cases(self.work_in("user"))

    def test_fields(self):
        version = self.output(self.tree / "bin" / "swellflow", "--version").split()[1]
        self.assertEqual(self.field("Package"), "swellflow")
        self.assertEqual(self.field("Version").partition("-")[0], version)
        self.assertEqual(self.field("Architecture"), self.output("dpkg", "--print-architecture").strip())
        for name in ("Maintainer", "Section", "Description"):
            self.assertTrue(self.field(name), name)
        self.assertEqual("for the processor that it was built on" in self.field("Description"), self.field("Version").endswith("-native"))

    def test_what_it_depends_on(self):
        needed = {alternatives.split()[0] for alternatives in self.field("Depends").split(",")}
        for package in ("openmpi-bin", "python3", "python3-numpy", "python3-matplotlib", "python3-vtk9",           # the runner
                        "libliggghts3", "libopenmpi3", "libvtk9.1", "libfftw3-double3", "libstdc++6", "libc6"):  # the program
            self.assertIn(package, needed)

    def test_contents(self):
        lines = self.output("dpkg-deb", "--contents", self.package).splitlines()
        names = {line.split()[5]: line for line in lines}
        for name in ("bin/swellflow", "bin/swellflow-case", "share/swellflow/cases/run", "share/swellflow/cases/channel/check", "share/swellflow/cases/channel/in.channel",
                     "share/doc/swellflow/copyright", "share/doc/swellflow/docs/fix_swell.md", "share/man/man1/swellflow.1"):
            self.assertIn(f"./usr/{name}", names)
        for name, line in names.items():
            self.assertRegex(line, r"^[dl-]r[w-][x-]r-[x-]r-[x-] root/root|^l\S+ root/root", line)
            self.assertNotIn("__pycache__", name)
            self.assertTrue(name.startswith("./usr/"), line)

    def test_nothing_of_the_machine_that_built_it(self):
        program = (self.tree / "bin" / "swellflow").read_bytes()
        for folder in (BUILD, SOURCES):
            self.assertNotIn(str(folder).encode(), program)


if __name__ == "__main__":
    unittest.main()
