"""Splits C++ source text into code, string literals and comments."""
import re

TOKEN = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"([^(\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)


def blank(text):
    """Returns spaces in place of text; line breaks stay."""
    return re.sub(r'[^\n]', ' ', text)


def code_of(text):
    """Returns the text with comments, literals and preprocessor lines blanked."""
    code = TOKEN.sub(lambda match: blank(match.group()), text)
    return re.sub(r'(?m)^[ \t]*#(?:[^\n\\]|\\.|\\\n)*', lambda match: blank(match.group()), code)


def string_literals(text):
    """Yields the line number and the text of each string literal."""
    for match in TOKEN.finditer(text):
        if match.group()[0] in '"R':
            yield text.count('\n', 0, match.start()) + 1, match.group()
