"""Finds types that are defined twice in a namespace of the project.

Reads C++ files named on the command line. Two definitions of a name in the same namespace are undefined
behavior, except in anonymous namespaces, whose types belong to one file. A typedef is reported, because
this check reads only `using`. Exit code 1 if there are any.
"""
import collections
import re
import sys

from source_text import code_of

HEAD = re.compile(r'(?:template\s*<[^{;]*>\s*)?\b(?:enum\s+(?:class|struct)|enum|class|struct|union)\s+'
                  r'(?:\[\[\w+\]\]\s*)?(?:alignas\([^)]*\)\s*)?([A-Za-z_]\w*)\b(?!\s*::)\s*'
                  r'(?P<specialization><)?[^;{}()=]*$')
NAMESPACE = re.compile(r'\bnamespace(?:\s+([\w:]+))?\s*$')
LINKAGE = re.compile(r'\bextern\s*$')  # string literals such as "C" are blanks in the text
ALIAS = re.compile(r'\s*using\s+([A-Za-z_]\w*)\s*=[^{}]*$')


def definitions(code):
    """Yields (namespace, name, position) for each type defined outside of anonymous namespaces."""
    scopes, begin = [], 0
    for match in re.finditer(r'[{};]', code):
        head = code[begin:match.start()]
        begin = match.end()
        in_namespace = all(scope[0] == 'namespace' for scope in scopes)
        is_anonymous = any(scope == ('namespace', None) for scope in scopes)
        where = ''.join(f'{scope[1]}::' for scope in scopes if scope[1])
        if match.group() == '}':
            if scopes:
                scopes.pop()
        elif match.group() == ';':
            alias = ALIAS.match(head)
            if alias and in_namespace and not is_anonymous:
                yield where, alias.group(1), match.start()
        elif namespace := NAMESPACE.search(head):
            scopes.append(('namespace', namespace.group(1)))
        elif LINKAGE.search(head):
            scopes.append(('namespace', ''))
        else:
            kind = HEAD.search(head)
            if kind and not kind['specialization'] and in_namespace and not is_anonymous:
                yield where, kind.group(1), match.start()
            scopes.append(('other', None))


def line_of(code, position):
    return code.count('\n', 0, position) + 1


def main(files):
    places, has_typedef = collections.defaultdict(list), False
    for name in files:
        with open(name, encoding='utf-8') as file:
            code = code_of(file.read())
        for match in re.finditer(r'\btypedef\b', code):
            print(f'lint: {name}:{line_of(code, match.start())}: a typedef; write using', file=sys.stderr)
            has_typedef = True
        for where, kind, position in definitions(code):
            places[where + kind].append(f'{name}:{line_of(code, position)}')
    twice = {name: found for name, found in places.items() if len(found) > 1}
    for name, found in sorted(twice.items()):
        print(f'lint: {name} is defined in {" and ".join(found)}', file=sys.stderr)
    if not places:
        print('lint: no type was found in the files', file=sys.stderr)
    return 1 if twice or has_typedef or not places else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
