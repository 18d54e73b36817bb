# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Reads a source tree for the checks: files, code without comments, includes, functions."""

import re
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

SKIPPED_FOLDERS = {".git", "build", "__pycache__"}
SOURCE_SUFFIXES = {".cpp", ".hpp"}

_COMMENT_OR_LITERAL = re.compile(
    r"""//(?:[^\n\\]|\\.|\\\n)*"""  # line comment
    r"""|/\*.*?\*/"""  # block comment
    r"""|(?:u8|[uUL])?R"(?P<tag>[^\s()\\]{0,16})\(.*?\)(?P=tag)\""""  # raw string
    r"""|"(?:[^"\\\n]|\\.)*\""""  # string
    r"""|(?<![0-9a-fA-F])'(?:[^'\\\n]|\\.)+'""",  # character, not a digit separator
    re.DOTALL | re.VERBOSE,
)
_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.MULTILINE)


def _blank(match: re.Match) -> str:
    """The same number of lines and columns, without the content."""
    text = match.group(0)
    if not text.startswith("/"):
        return '"' + re.sub(r"[^\n]", " ", text[1:-1]) + '"'
    return re.sub(r"[^\n]", " ", text)


@dataclass(frozen=True)
class Include:
    line: int
    target: str
    system: bool


@dataclass(frozen=True)
class Function:
    line: int
    num_lines: int


@dataclass
class SourceFile:
    path: str
    text: str

    @cached_property
    def code(self) -> str:
        """The text with comments and the inside of literals turned into blanks."""
        return _COMMENT_OR_LITERAL.sub(_blank, self.text)

    @cached_property
    def lines(self) -> list[str]:
        return self.text.splitlines()

    @property
    def is_source(self) -> bool:
        return Path(self.path).suffix in SOURCE_SUFFIXES

    @property
    def is_header(self) -> bool:
        return self.path.endswith(".hpp")

    def num_code_lines(self) -> int:
        return sum(1 for line in self.code.splitlines() if line.strip())

    def includes(self) -> list[Include]:
        # A quoted target is a literal: it is blank in `code`, so a comment is told apart there.
        return [
            Include(self.line_of(m.start(1)), m.group(2), m.group(1) == "<")
            for m in _INCLUDE.finditer(self.text)
            if self.code[m.start(1)] != " "
        ]

    def line_of(self, offset: int) -> int:
        return self.text.count("\n", 0, offset) + 1

    def functions(self) -> list[Function]:
        """Function bodies outside other functions, from the declaration to the closing brace."""
        code = re.sub(r"^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", lambda m: re.sub(r"[^\n]", " ", m.group(0)),
                      self.code, flags=re.MULTILINE)
        found = []
        depth = 0  # braces open inside the current function
        head = 0  # where the current declaration starts
        for token in re.finditer(r"[{};]", code):
            if token.group() == "{":
                if depth > 0:
                    depth += 1
                elif _opens_scope(code[head:token.start()]):
                    head = token.end()
                else:
                    depth = 1
            elif token.group() == "}":
                if depth > 0:
                    depth -= 1
                if depth == 0:
                    declaration = code[head:token.end()]
                    # `Class() : a_{1}, b_(f({2})) {`: the body is still to come.
                    if re.match(r"\s*[,{)]", code[token.end():]):
                        continue
                    if re.search(r"\)[^;{}]*\{", declaration):
                        first = head + len(declaration) - len(declaration.lstrip())
                        num_lines = code.count("\n", first, token.end()) + 1
                        found.append(Function(self.line_of(first), num_lines))
                    head = token.end()
            elif depth == 0:
                head = token.end()
        return found


def _opens_scope(declaration: str) -> bool:
    """Whether a brace after this text opens a namespace or a type rather than a function."""
    return bool(
        re.search(r"\bnamespace\b|\bextern\s*\"", declaration)
        or re.search(r"\b(class|struct|union|enum)\b(?![^<]*>)[^()]*$", declaration)
    )


@dataclass
class Tree:
    root: Path
    files: dict[str, SourceFile] = field(default_factory=dict)

    def sources(self, *folders: str) -> list[SourceFile]:
        """The .cpp and .hpp files under these folders; without folders, all of them."""
        return [
            file
            for file in self.files.values()
            if file.is_source and (not folders or file.path.split("/")[0] in folders)
        ]


def load_tree(root: Path) -> Tree:
    """All text files below root, by path relative to it."""
    tree = Tree(root)
    for path in sorted(root.rglob("*")):
        relative = path.relative_to(root)
        if SKIPPED_FOLDERS & set(relative.parts) or not path.is_file():
            continue
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        tree.files[relative.as_posix()] = SourceFile(relative.as_posix(), text)
    return tree
