"""Lists the texts of errors, warnings and notes in C++ files, so that they can be read in one go.

    messages.py HELP... -- FILE...

Prints `file: text` for each text of at least three words in a string literal. Expressions between literals are
printed as an ellipsis. Texts that the help files HELP contain are left out, because those files are read anyway.
"""
import re
import sys

from source_text import CPP

LEAST_WORDS = 3
ELLIPSIS = '…'
# Tables, code of other languages, and patterns are no sentences.
NO_SENTENCE = re.compile(r'[<>{}]|\\n|%[0-9.]*[a-z]|^[#@]|(?:^| )[a-z_]+=')
WORD = re.compile(r"(?<![\w.-])[A-Za-z][a-z']+(?![\w(/])")


def literal_text(literal):
    """Returns the contents of a string literal; escaped quotes are quotes."""
    if literal.startswith('R'):
        return literal[literal.index('(') + 1:literal.rindex(')')]
    return literal[1:-1].replace('\\"', '"').replace('\\\\', '\\')


def tokens(text):
    """Yields ('literal', text) for string literals and ('code', text) for what lies between them."""
    end = 0
    for match in CPP.finditer(text):
        if match['string'] or match['comment'] or match['character']:
            yield 'code', text[end:match.start()]
            end = match.end()
        if match['string']:
            yield 'literal', literal_text(match['string'])
        elif match['character']:
            yield 'code', " c "
    yield 'code', text[end:]


def is_end(code):
    """True if the code between two literals ends the text of the first one."""
    depth = 0
    for character in code.replace('::', ''):
        depth += {'(': 1, ')': -1, '[': 1, ']': -1}.get(character, 0)
        if character in ';{}' or (depth <= 0 and character in ',?:') or depth < 0:
            return True
    return False


def with_counts(text):
    """Replaces `counted(number, "vertex")` by the literal "… vertex"."""
    result = ''
    while match := re.search(r'\bcounted\(', text):
        end = match.end()
        depth = 1
        while depth > 0 and end < len(text):
            depth += {'(': 1, ')': -1}.get(text[end], 0)
            end += 1
        noun = re.findall(r'"(\w+)"', text[match.end():end])
        result += text[:match.start()] + (f'"{ELLIPSIS} {noun[0]}"' if noun else text[match.start():end])
        text = text[end:]
    return result + text


def messages(text):
    """Yields the texts of a file: literals that are joined by + or stand beside each other are one."""
    current, before = '', ''
    for kind, part in tokens(with_counts(text)):
        if kind == 'literal':
            if not current and before.rstrip().endswith('+'):
                current = ELLIPSIS
            current += part
            before = ''
            continue
        before += part
        code = before.strip()
        if not current or not code:
            continue
        if code.startswith('+') and not is_end(code):
            current += '' if code == '+' else ELLIPSIS
            before = ''
            continue
        yield current + (ELLIPSIS if code.startswith('+') else '')
        current = ''
    if current:
        yield current


def is_sentence(text):
    return not NO_SENTENCE.search(text) and len(WORD.findall(text)) >= LEAST_WORDS


def main(arguments):
    split = arguments.index('--')
    known = ''
    for name in arguments[:split]:
        with open(name, encoding='utf-8') as file:
            known += ' ' + re.sub(r'\s+', ' ', file.read())
    for name in arguments[split + 1:]:
        with open(name, encoding='utf-8') as file:
            text = file.read()
        for message in dict.fromkeys(messages(text)):
            if is_sentence(message) and re.sub(r'\s+', ' ', message).strip() not in known:
                print(f'{name}: {message}')


if __name__ == '__main__':
    main(sys.argv[1:])
