"""The package as a whole: version, types of all public names, docstrings, notebooks."""

import ast
import inspect
import io
import json
import os
import subprocess
import tempfile
import unittest
from contextlib import redirect_stdout
from pathlib import Path

import hunavsim

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "app" / "python"


class PackageTest(unittest.TestCase):
    def test_version_is_that_of_the_program(self):
        words = subprocess.run([os.environ["HUNAVSIM"], "--version"], check=True,
                               capture_output=True, text=True).stdout.split()
        self.assertIn(hunavsim.__version__, " ".join(words))

    def test_types_describe_all_public_names_and_members(self):
        tree = ast.parse((SOURCES / "hunavsim" / "__init__.pyi").read_text())
        classes = {node.name: {item.name for item in node.body
                               if isinstance(item, ast.FunctionDef)}
                   for node in tree.body if isinstance(node, ast.ClassDef)}
        functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
        self.assertEqual(set(hunavsim.__all__) - {"__version__"}, set(classes) | functions)
        for name, members in classes.items():
            public = {member for member in vars(getattr(hunavsim, name))
                      if not member.startswith("_")}
            members -= {"problems"} if name == "ScenarioError" else set()
            self.assertEqual({m for m in members if not m.startswith("_")}, public, name)

    def test_public_names_have_docstrings(self):
        for name in hunavsim.__all__:
            if name != "__version__":
                self.assertTrue(inspect.getdoc(getattr(hunavsim, name)), name)

    def test_notebooks_run(self):
        notebooks = sorted((SOURCES / "examples").glob("*.ipynb"))
        self.assertGreaterEqual(len(notebooks), 3)
        for notebook in notebooks:
            cells = json.loads(notebook.read_text())["cells"]
            code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
            names = {"__name__": "__main__"}
            before = os.getcwd()
            with self.subTest(notebook.name), tempfile.TemporaryDirectory() as folder:
                os.chdir(folder)
                os.environ["MPLBACKEND"] = "Agg"
                try:
                    with redirect_stdout(io.StringIO()):
                        for cell in code:
                            exec(compile(cell, notebook.name, "exec"), names)
                finally:
                    os.chdir(before)


if __name__ == "__main__":
    unittest.main()
