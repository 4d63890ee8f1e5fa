"""Splits source text into code, string literals and comments."""
import re

# In C++ a single quote between digits is a separator and does not begin a literal.
CPP = re.compile(
    r'(?P<comment>//[^\n]*|/\*.*?\*/)|\b\d[\w.]*(?:\'\w+)+'
    r'|(?P<string>R"([^(\s]*)\(.*?\)\3"|"(?:\\.|[^"\\\n])*")|(?P<character>\'(?:\\.|[^\'\\\n])+\')', re.S)
SHELL = re.compile(
    r'(?P<comment>(?:^|(?<=[\s;]))#[^\n]*)|\\.|(?P<string>\'[^\']*\'|"(?:\\.|[^"\\])*"'
    r'|(?<!<)<<-?\s*[\'"]?(?P<end>\w+)[\'"]?[^\n]*\n(?:.*?\n)?\t*(?P=end)$)', re.S | re.M)
PYTHON = re.compile(
    r'(?P<comment>\#[^\n]*)|(?P<string>(\'{3}|"{3}).*?\3|\'(?:\\.|[^\'\\\n])*\'|"(?:\\.|[^"\\\n])*")', re.S)
CMAKE = re.compile(r'(?P<comment>#[^\n]*)|(?P<string>\[(=*)\[.*?\]\3\]|"(?:\\.|[^"\\])*")', re.S)
TOKENS = {'.h': CPP, '.cpp': CPP, '.js': CPP, '.py': PYTHON, '.txt': CMAKE, '.cmake': CMAKE}


def tokens_of(name):
    """Returns the pattern of comments and strings of a file's language; the shell is the default."""
    return TOKENS.get(name[name.rfind('.'):] if '.' in name else '', SHELL)


def blank(text):
    """Returns spaces in place of text; line breaks stay."""
    return re.sub(r'[^\n]', ' ', text)


def without_strings(text, name):
    """Returns the text with string literals blanked."""
    return tokens_of(name).sub(lambda match: blank(match[0]) if match['string'] else match[0], text)


def code_of(text):
    """Returns C++ text with comments, literals and preprocessor lines blanked."""
    code = CPP.sub(lambda match: blank(match[0]) if match.lastgroup else match[0], text)
    return re.sub(r'(?m)^[ \t]*#(?:[^\n\\]|\\.|\\\n)*', lambda match: blank(match[0]), code)


def string_literals(text):
    """Yields the line number and the text of each string literal of C++ text."""
    for match in CPP.finditer(text):
        if match['string']:
            yield text.count('\n', 0, match.start()) + 1, match['string']
