"""Where functions stand: a package's readers under its name, what packages share in formats/ and models/, and nothing there that one package alone needs."""

import ast
import re
import unittest
from collections import defaultdict

import sources

FOLDERS = ("formats", "models", "readers")


def module_of(package):
    """The module of a package's readers."""
    return "readers." + re.sub(r"[-.]", "_", package).lower()


def imported(tree):
    """What a file takes from the folders, by the names that it has there."""
    found = [node for node in tree.body if isinstance(node, ast.ImportFrom) and node.module.split(".")[0] in FOLDERS]
    return {one.asname or one.name: f"{node.module}.{one.name}" for node in found for one in node.names}


def defined(tree):
    """Functions, classes and constants of a file."""
    for node in tree.body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield node.name, node
        elif isinstance(node, ast.Assign):
            yield from ((part.id, node) for part in ast.walk(node.targets[0]) if isinstance(part, ast.Name))


def modules():
    """Files of the folders, read, by their names."""
    paths = [path for folder in FOLDERS for path in sorted((sources.HERE / folder).glob("*.py")) if path.stem != "__init__"]
    return {f"{path.parent.name}.{path.stem}": ast.parse(path.read_text(encoding="utf-8")) for path in paths}


def callers(files):
    """Of each name of the folders the names of the folders that use it."""
    found = defaultdict(set)
    for module, tree in files.items():
        known = {**imported(tree), **{name: f"{module}.{name}" for name, _ in defined(tree)}}
        for name, node in defined(tree):
            for part in ast.walk(node):
                if isinstance(part, ast.Name) and part.id in known:
                    found[known[part.id]].add(f"{module}.{name}")
    return found


class Layout(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.files, cls.used = modules(), defaultdict(set)
        for one in sources.recordings().values():
            tree = ast.parse((sources.HERE / "recordings" / f"{one.name}.py").read_text(encoding="utf-8"))
            for name in imported(tree).values():
                cls.used[name].add(one.archive.package)

    def packages(self, name, above, seen):
        """Packages whose recordings reach a name."""
        if name in seen:
            return set()
        seen.add(name)
        return self.used[name].union(*(self.packages(one, above, seen) for one in above[name]))

    def test_each_reader_is_a_package_and_only_its_recordings_use_it(self):
        packages = {module_of(one.archive.package): one.archive.package for one in sources.recordings().values()}
        for module, tree in self.files.items():
            if module.startswith("readers."):
                self.assertTrue(module in packages, f"{module} has the name of no package; what packages share is in formats/ or models/")
                others = {name for name in imported(tree).values() if name.startswith("readers.")}
                self.assertEqual(others, set(), f"{module} takes from other packages' readers what belongs in formats/ or models/")
        for name, used in self.used.items():
            if name.startswith("readers."):
                self.assertEqual(used, {packages[name.rpartition(".")[0]]}, f"{name} is used by other packages too: it belongs in formats/ or models/")

    def test_what_is_shared_is_used_by_two_packages_and_all_is_used(self):
        above = callers(self.files)
        for module, tree in self.files.items():
            for name, _ in defined(tree):
                used = self.packages(f"{module}.{name}", above, set())
                least = 1 if module.startswith("readers.") else 2
                self.assertGreaterEqual(len(used), least, f"{module}.{name} is used by {sorted(used) or 'nothing'}")

    def test_formats_know_no_models_and_models_no_formats(self):
        for module, tree in self.files.items():
            folder = module.split(".")[0]
            below = {name.split(".")[0] for name in imported(tree).values()}
            self.assertLessEqual(below, set(FOLDERS) if folder == "readers" else {folder}, module)

    def test_no_function_is_there_twice(self):
        found = defaultdict(list)
        for module, tree in self.files.items():
            for node in (node for node in tree.body if isinstance(node, ast.FunctionDef)):
                body = node.body[ast.get_docstring(node) is not None :]
                found[ast.unparse(node.args), "\n".join(map(ast.unparse, body))].append(f"{module}.{node.name}")
        self.assertEqual([names for names in found.values() if len(names) > 1], [])


if __name__ == "__main__":
    unittest.main()
