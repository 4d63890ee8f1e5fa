"""Finds names of options and programs in the string literals of C++ files.

Reads C++ files named on the command line. The library is used from C++ and Python, where programs and
their options do not exist. Exit code 1 if there are any.
"""
import re
import sys

from source_text import string_literals

NAME = re.compile(r'(?<![-\w!<])(?:--[a-z][a-z-]*|tm-[a-z][a-z-]*)')


def main(files):
    found = 0
    for name in files:
        with open(name, encoding='utf-8') as file:
            text = file.read()
        for line, literal in string_literals(text):
            for option in NAME.findall(re.sub(r'\\.', ' ', literal)):
                print(f'lint: {name}:{line}: a string names {option}', file=sys.stderr)
                found += 1
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
