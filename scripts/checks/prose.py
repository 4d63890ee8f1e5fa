"""Checks prose: comments, Markdown texts and commit subjects.

    prose.py COMMIT FILE...

Reports comments that begin with a word that refers to something else (of, where, it), and sentences of
more than 30 words. References to the literature may be longer. In files of the folder lib, reports
constants of number types without a comment above or beside them, where their reason belongs. Also
reports subjects of commits since COMMIT that are longer than 72 characters. Exit code 1 if there are any.
"""
import re
import subprocess
import sys

from source_text import blank, without_strings

MOST_WORDS = 30
MOST_SUBJECT = 72
FIRST_WORDS = ('what|where|of|with|by|as|and|but|else|another|anew|then|from now on|those|such|so many|it|that')
FIRST = re.compile(rf'(?:{FIRST_WORDS})\b', re.I)
CPP_COMMENT = re.compile(r'///?<?(?!/)')
SHELL_COMMENT = re.compile(r'(?:^|(?<=\s))#(?![!#{])')
SENTENCE_END = re.compile(r'(?:(?<=[.!?])|(?<=[.!?][)"*`]))(?<!e\.g\.)(?<!i\.e\.)(?<!\bal\.)(?<!\bvs\.)'
                          r'\s+(?=[A-Z`"(*\[])')
NUMBER_TYPE = r'(?:double|float|int|long|unsigned|Index|std::size_t|std::u?int\d+_t)'
CONSTANT = re.compile(rf'\s*(?:static |inline )*constexpr {NUMBER_TYPE} \w+(?: =|{{)')
LIST_ITEM = re.compile(r'\s*[-*] ')
MARKDOWN_BREAK = re.compile(r'\s*(?:[-*+] |\d+\. |>|:   |\||#|$)|.* \| ')


def comment_start(line, name):
    """Returns where the text of the comment on a line begins, and whether code precedes it."""
    is_cpp = name.endswith(('.cpp', '.h', '.js'))
    match = (CPP_COMMENT if is_cpp else SHELL_COMMENT).search(line)
    if not match:
        return None, False
    return match.end(), bool(line[:match.start()].strip())


def comments(lines, name):
    """Yields (line number, text) of each comment; consecutive whole-line comments are one."""
    number, text, is_trailing = 0, [], False
    for i, line in enumerate(lines + [''], 1):
        start, follows_code = comment_start(line, name)
        part = None if start is None else line[start:].rstrip('\n')
        is_sample = part is not None and part.startswith('    ' if name.endswith(('.cpp', '.h')) else '  ')
        ends_trailing = is_trailing and '///' in line and '///<' not in line
        is_item = part is not None and LIST_ITEM.match(part)
        if part is None or follows_code or is_sample or is_item or ends_trailing or not part.strip():
            if text:
                yield number, ' '.join(text)
            text = []
        if part is None or is_sample or not part.strip():
            continue
        if not text:
            number, is_trailing = i, follows_code
        text.append(LIST_ITEM.sub('', part, 1).strip())
    if text:
        yield number, ' '.join(text)


def paragraphs(lines):
    """Yields (line number, text) of each paragraph and list item of a Markdown text."""
    number, text, is_fenced = 0, [], False
    for i, line in enumerate(lines + [''], 1):
        is_fence = line.lstrip().startswith('```')
        is_code = is_fenced or is_fence or (not text and re.match(r' {4,}|\t', line))
        if is_fence:
            is_fenced = not is_fenced
        if is_code or MARKDOWN_BREAK.match(line):
            if text:
                yield number, ' '.join(text)
            text = []
        if is_code or re.match(r'\s*(?:[|#>]|$)|.* \| ', line):
            continue
        if not text:
            number = i
        text.append(re.sub(r'^\s*(?:[-*+] |\d+\. |:   )?', '', line).strip())


def sentences(text):
    return SENTENCE_END.split(text)


def count_words(sentence):
    """Counts words; a code span, a formula or a link is one."""
    plain = re.sub(r'`[^`]*`', 'x', sentence)
    plain = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', plain)
    return sum(1 for word in plain.split() if re.search(r'\w', word))


def constants_without_reason(lines):
    """Yields (line number, line) of each constant that has no comment. A comment above a group is enough."""
    is_explained = False
    for i, line in enumerate(lines):
        match = CONSTANT.match(line)
        if not match:
            is_explained = '//' in line or (is_explained and line.lstrip().startswith('template'))
            continue
        end = next((j for j in range(i, len(lines)) if ';' in lines[j]), i)
        definition = '\n'.join(lines[i:end + 1])
        has_number = re.search(r'(?<!\w)\.?\d', definition[match.end():].split('//')[0])
        if has_number and not is_explained and '//' not in definition:
            yield i + 1, line.strip()


def problems_of(name, text):
    """Yields (line number, sentence, problem)."""
    is_markdown = name.endswith('.md')
    if is_markdown:
        text = re.sub(r'<!--.*?-->', lambda match: blank(match[0]), text, flags=re.S)
    else:
        text = without_strings(text, name)
    lines = text.split('\n')
    if name.startswith('lib/'):
        for line, constant in constants_without_reason(lines):
            yield line, constant, 'a constant without a reason'
    for line, block in paragraphs(lines) if is_markdown else comments(lines, name):
        parts = sentences(block)
        if not is_markdown and FIRST.match(parts[0]):
            yield line, parts[0], f"begins with '{FIRST.match(parts[0]).group()}'"
        for sentence in parts:
            words = count_words(sentence)
            if words > MOST_WORDS and not sentence.startswith('Reference'):
                yield line, sentence, f'a sentence of {words} words'


def git(*arguments):
    return subprocess.run(['git', *arguments], check=True, capture_output=True, text=True,
                          errors='replace').stdout


def long_subjects(commit):
    for line in git('log', '--format=%h %s', f'{commit}..HEAD').splitlines():
        number, _, subject = line.partition(' ')
        if len(subject) > MOST_SUBJECT:
            yield f'commit {number}: a subject of {len(subject)} characters: {subject}'


def main(commit, files):
    found = list(long_subjects(commit))
    for name in files:
        with open(name, encoding='utf-8', errors='replace') as file:
            text = file.read()
        for line, sentence, problem in problems_of(name, text):
            found.append(f'{name}:{line}: {problem}: {sentence}')
    for problem in found:
        print(f'lint: {problem}', file=sys.stderr)
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], sys.argv[2:]))
