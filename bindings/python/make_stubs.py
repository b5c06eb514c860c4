#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Writes what type checkers read of the client interface: the signatures that SWIG notes in its docstrings.

usage: make_stubs.py MODULE.py FOLDER

They become packages of stubs (PEP 561) in the folder: one for the module, and one for soar_sml, its other name.
"""
import ast
import pathlib
import re
import sys

HEAD = '''# SPDX-License-Identifier: BSD-2-Clause
# Made from the module by make_stubs.py.
import os
from typing import Any, Callable, List, Optional, Union, overload

'''

#: Functions that return None if nothing has the given name or index.
MAY_BE_NONE = re.compile(r"Get(ParameterValue|Child|Agent|AgentByIndex|Command|ConnectionInfo|ConnectionStatus|AgentStatus|"
                         r"OutputLink|OutputLinkChange|Attribute|IDAtt\w*|ValueAsString)$|FindBy|Find\w*|ConvertTo")
TEXTS = ("char", "string")
NUMBERS = ("int", "long", "unsigned", "short", "size_t")


def type_of(text, classes):
    """The Python type of a C++ type as SWIG writes it."""
    words = re.sub(r"[*&]|\bconst\b|\b\w+::", " ", text).split()
    if any(word.startswith(TEXTS) for word in words):
        return "str"
    if "PyObject" in words:
        return "Any"
    if "bool" in words:
        return "bool"
    if any(word in ("float", "double") for word in words):
        return "float"
    named = [word for word in words if word in classes]
    if named:
        return named[0]
    if any(word in NUMBERS for word in words) or any(word.startswith("sml") for word in words):
        return "int"
    return "None" if words == ["void"] or not words else "Any"


def parameters_of(text, classes):
    made = []
    depth, part = 0, ""
    for character in text + ",":
        if character == "," and depth == 0:
            if part.strip():
                made.append(parameter_of(part.strip(), len(made), classes))
            part = ""
            continue
        depth += (character in "(<[") - (character in ")>]")
        part += character
    return made


def parameter_of(text, place, classes):
    text, _, default = text.partition("=")
    found = re.match(r"(.*?)(\w+)\s*$", text)
    kind, name = (found[1], found[2]) if found and found[1].strip() else (text, f"arg{place}")
    if name == "self":
        return "self"
    if name in ("func", "handler"):
        kind = "Callable[..., Any]"
    else:
        kind = type_of(kind, classes)
        if default == "None" and kind != "Any":
            kind = f"Optional[{kind}]"
    if name in ("None", "True", "False", "from", "in", "is", "lambda"):
        name += "_"
    return f"{name}: {kind}" + (" = ..." if default else "")


def functions_of(node, indent, classes, is_static):
    """The stub of a function: one signature, or several."""
    signatures = [line for line in (ast.get_docstring(node) or "").splitlines()
                  if re.match(rf"{node.name}\(.*\)", line.strip())]
    lines, made = [], []
    for signature in signatures:
        inside, _, result = signature.strip().partition(") -> ") if ") -> " in signature else (signature.strip()[:-1], "", "void")
        parameters = parameters_of(inside[len(node.name) + 1:], classes)
        kind = type_of(result, classes)
        if MAY_BE_NONE.match(node.name) and kind not in ("int", "bool", "float", "None", "Any"):
            kind = f"Optional[{kind}]"
        if indent and not is_static and "self" not in parameters:
            parameters.insert(0, "self")
        types = [parameter.partition(": ")[2].replace("int", "float") for parameter in parameters]
        # Signatures that differ only in int and float count as one, because Python accepts an int for a float.
        if all(types != others for others, _ in made):
            made.append((types, f"{indent}def {node.name}({', '.join(parameters)}) -> {kind}: ..."))
    for _, text in made:
        lines += [f"{indent}@overload"] * (len(made) > 1) + [f"{indent}@staticmethod"] * is_static + [text]
    return lines


def constants_of(node, indent, kind):
    """`name = _module.name`: a constant, or another name of a function."""
    if not isinstance(node, ast.Assign) or not isinstance(node.targets[0], ast.Name):
        return []
    name = node.targets[0].id
    if name.startswith("_") or name == "thisown" or not isinstance(node.value, ast.Attribute):
        return []
    return [f"{indent}{name}: {kind}"]


def class_of(node, classes):
    bases = ", ".join(base.id for base in node.bases if isinstance(base, ast.Name) and base.id != "object")
    lines = [f"class {node.name}({bases}):" if bases else f"class {node.name}:"]
    body = []
    for each in node.body:
        if isinstance(each, ast.FunctionDef) and not each.name.startswith("_"):
            is_static = any(isinstance(one, ast.Name) and one.id == "staticmethod" for one in each.decorator_list)
            body += functions_of(each, "    ", classes, is_static)
        else:
            body += constants_of(each, "    ", "str" if node.name == "sml_Names" else "int")
    if node.name == "Kernel":
        body.append("    def record(self, file: Union[str, \"os.PathLike[str]\"]) -> None: ...")
    return lines + (body or ["    ..."])


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    tree = ast.parse(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    classes = {node.name for node in tree.body if isinstance(node, ast.ClassDef)}
    lines = []
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            lines += class_of(node, classes) + [""]
        elif isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            lines += functions_of(node, "", classes, False)
        else:
            lines += constants_of(node, "", "int")
    write(sys.argv[2], "Python_sml_ClientInterface", HEAD + "\n".join(lines) + "\n")
    write(sys.argv[2], "soar_sml", "# SPDX-License-Identifier: BSD-2-Clause\nfrom Python_sml_ClientInterface import *\n")


def write(folder, module, text):
    package = pathlib.Path(folder) / f"{module}-stubs"
    package.mkdir(parents=True, exist_ok=True)
    (package / "__init__.pyi").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
