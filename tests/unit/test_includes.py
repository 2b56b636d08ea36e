"""Dependencies point one way, fluid <- coupling -> liggghts_plugins, and objects/ and fluid/ know nothing of LIGGGHTS."""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIGGGHTS = Path("/usr/include/liggghts")

# Folder: what may not be included there.
FORBIDDEN = {
    "fluid": {"LIGGGHTS", "coupling", "liggghts_plugins"},
    "liggghts_plugins": {"fluid", "coupling"},
    "liggghts_plugins/objects": {"LIGGGHTS", "fluid", "coupling"},
}


def owner(name, file):
    """Whose header an #include names: one of our folders, LIGGGHTS, or another's (None)."""
    for base in (file.parent, ROOT):
        path = (base / name).resolve()
        if path.exists() and path.is_relative_to(ROOT):
            return path.relative_to(ROOT).parts[0]
    if name.startswith("liggghts/") or (LIGGGHTS / name).exists():
        return "LIGGGHTS"
    return None


def includes(file):
    return re.findall(r'^\s*#\s*include\s*["<]([^">]+)[">]', file.read_text(), re.M)


class Includes(unittest.TestCase):
    def test_dependencies_point_one_way(self):
        for folder, forbidden in FORBIDDEN.items():
            files = [file for file in (ROOT / folder).rglob("*") if file.suffix in (".h", ".cpp")]
            self.assertTrue(files, folder)
            for file in files:
                for name in includes(file):
                    self.assertNotIn(owner(name, file), forbidden, f"{file.relative_to(ROOT)} includes {name}")

    def test_the_scan_sees_what_it_forbids(self):
        file = ROOT / "coupling" / "main.cpp"
        self.assertEqual(owner("lammps.h", file), "LIGGGHTS")
        self.assertEqual(owner("liggghts/library.h", file), "LIGGGHTS")
        self.assertEqual(owner("liggghts_plugins/fluid_partner.h", file), "liggghts_plugins")
        self.assertIsNone(owner("vector", file))


if __name__ == "__main__":
    unittest.main()
