#!/usr/bin/python3
"""Mutation testing with mutant schemata: all mutants of a module are in one program, and $NB_MUTANT chooses one.

  make mutants MODULE=verdict SAMPLE=100 SEED=1 ALSO="cases checkpoint" JOBS=2

libclang finds the mutants in the syntax tree; `alternatives` lists the kinds. A mutant that does not compile is left
out. Every check runs once without a mutant, which records its time and the places it reaches. For each mutant
of the sample (SAMPLE=all: every mutant) the checks that reach it run, the shortest first, until one fails. A check
that takes more than three times its time without a mutant, plus two seconds of processor time, has failed. The checks are the
unit suites and the invalid pages; ALSO adds the pages of `cases`, and scripts by name. MODULE is the name of a module in
tests/mutants/rules.txt, or part of the name of a file. MUTANT=N runs one mutant. Rules `equal` name equivalent mutants.

Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
"""
import concurrent.futures
import glob
import hashlib
import json
import os
import queue
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import clang.cindex as clang
from clang.cindex import CursorKind as Kind, TypeKind

env = os.environ
source, build = os.path.abspath(env["srcdir"]), os.getcwd()


def stop(words):
    sys.exit("mutants: " + words)


# ---- the files of the module, and the rules --------------------------------------------------------------------------


def read_rules():
    """Returns the globs of each module, and the set of (file, changed line) of the rules `equal`."""
    modules, equal, kind, file = {}, set(), None, None
    with open(source + "/tests/mutants/rules.txt") as lines:
        for line in lines:
            words = line.split()
            if words[:1] == ["module"]:
                modules[words[1]] = words[2:]
            elif words[:1] in (["mutant"], ["equal"]):
                kind = words[0]
            elif words[:1] == ["in"]:
                file = words[1]
            elif words[:1] == ["+"] and kind == "equal":
                equal.add((file, " ".join(words[1:])))
    return modules, equal


def files_of(module, modules):
    names = [n for g in modules.get(module, ["src/*/*.[ch]", "cases/refs/*.[ch]"]) for n in sorted(glob.glob(g, root_dir=source))]
    return names if module in modules else [n for n in names if module in n]


# ---- the mutants of a file -------------------------------------------------------------------------------------------

INTEGERS = {TypeKind.INT, TypeKind.UINT, TypeKind.LONG, TypeKind.ULONG, TypeKind.LONGLONG, TypeKind.ULONGLONG, TypeKind.UCHAR, TypeKind.SHORT, TypeKind.USHORT}
REALS = {TypeKind.DOUBLE, TypeKind.FLOAT}
EXCHANGED = {"<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="], "+": ["-"], "-": ["+"],
             "*": ["/"], "/": ["*"], "%": ["*"], "&&": ["||"], "||": ["&&"], "&": ["|"], "|": ["&"], "<<": [">>"], ">>": ["<<"],
             "+=": ["-="], "-=": ["+="], "*=": ["/="], "/=": ["*="]}
OPPOSITE = {"fmin": "fmax", "fmax": "fmin"}
SYMMETRIC = {"fmin", "fmax", "hypot", "strcmp", "strncmp", "memcmp", "vec_dot", "vec_add", "tensor_add"} # the result does not depend on the order of two arguments, or only its sign does


class Unit:
    """Collects in `edits` the mutants of the files `wanted` in one translation unit: file -> {(start, end, is statement): texts}."""

    def __init__(self, path, wanted, flags, edits):
        self.wanted, self.edits, self.texts = wanted, edits, {}
        unit = clang.Index.create().parse(path, flags, options=clang.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
        self.macros = {}
        for node in unit.cursor.get_children():
            if node.kind == Kind.MACRO_INSTANTIATION and self.file(node):
                self.macros.setdefault(self.file(node), []).append((node.extent.start.offset, node.extent.end.offset))
        for node in unit.cursor.get_children():
            if node.kind == Kind.FUNCTION_DECL and node.is_definition() and self.file(node):
                self.name, self.result = self.file(node), node.result_type.get_canonical().kind
                if self.name not in self.texts:
                    with open(os.path.join(source, self.name), "rb") as file:
                        self.texts[self.name] = file.read().decode("latin-1")
                self.text = self.texts[self.name]
                for child in node.get_children():
                    if child.kind == Kind.COMPOUND_STMT:
                        self.visit(child, True)

    def file(self, node):
        if not node.location.file:
            return None
        name = os.path.relpath(node.location.file.name, source)
        return name if name in self.wanted else None

    def of(self, node):
        return self.text[node.extent.start.offset:node.extent.end.offset]

    def add(self, node, text, statement=False):
        start, end = node.extent.start.offset, node.extent.end.offset
        if any(a <= start and end <= b for a, b in self.macros.get(self.name, [])) or end <= start:
            return
        if text.strip() != self.of(node):
            self.edits.setdefault(self.name, {}).setdefault((start, end, statement), {})[text] = None

    def visit(self, node, statement):
        """Visits an expression or statement; `statement` says that its value is not used."""
        kind, children = node.kind, list(node.get_children())
        if kind == Kind.CXX_UNARY_EXPR or kind == Kind.CASE_STMT and len(children) < 2: # sizeof
            return
        self.alternatives(node, kind, children, statement)
        skipped = []
        if kind == Kind.CASE_STMT:
            skipped = children[:1]
        elif kind == Kind.VAR_DECL:
            first = self.of(node).find("=")
            begin = node.extent.start.offset + first
            skipped = [c for c in children if first < 0 or node.storage_class == clang.StorageClass.STATIC or c.extent.start.offset < begin]
        elif kind == Kind.FOR_STMT:
            at, depth, marks = node.extent.start.offset, 0, 0
            while marks < 2: # the increment begins after the second semicolon
                at += 1
                marks += self.text[at] == ";"
            skipped = [c for c in children[:-1] if c.extent.start.offset > at]
        nested = kind in (Kind.COMPOUND_STMT, Kind.CASE_STMT, Kind.DEFAULT_STMT, Kind.LABEL_STMT)
        parts = {Kind.IF_STMT: children[1:], Kind.WHILE_STMT: children[1:], Kind.FOR_STMT: children[-1:], Kind.DO_STMT: children[:1], Kind.SWITCH_STMT: children[1:]}
        for child in children:
            if child not in skipped:
                self.visit(child, nested or child in parts.get(kind, []))

    def alternatives(self, node, kind, children, statement):
        type_ = node.type.get_canonical().kind
        if kind in (Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR) and len(children) == 2:
            left, right = children
            between = self.text[left.extent.end.offset:right.extent.start.offset]
            operator = re.sub(r"/\*.*?\*/|//.*", "", between, flags=re.S).strip()
            for new in EXCHANGED.get(operator, []):
                self.add(node, self.of(left) + between.replace(operator, new) + self.of(right), False)
            if operator in ("&&", "||"): # an operand is left out
                self.add(node, self.of(left))
                self.add(node, self.of(right))
            if operator.endswith("=") and operator not in EXCHANGED or operator in ("+=", "-=", "*=", "/="):
                self.scaled(right)
                if statement:
                    self.add(node, "", True)
        elif kind == Kind.UNARY_OPERATOR and children:
            operator = self.text[node.extent.start.offset:children[0].extent.start.offset].strip()
            if operator in ("-", "!"):
                self.add(node, self.of(children[0]))
            elif "++" in self.of(node) or "--" in self.of(node):
                self.add(node, "" if statement else self.of(children[0]), statement)
        elif kind == Kind.INTEGER_LITERAL:
            self.add(node, "1" if self.of(node) == "0" else "(" + self.of(node) + " + 1)")
        elif kind == Kind.FLOATING_LITERAL:
            self.add(node, "(" + self.of(node) + " * 1.001)")
        elif kind == Kind.CALL_EXPR:
            given, name = list(node.get_arguments()), node.spelling
            if statement and name and not name.endswith("free"):
                self.add(node, "", True)
            for a, b in zip(given, given[1:]):
                if a.type.get_canonical() == b.type.get_canonical() and self.of(a) != self.of(b) and not (a is given[0] and name in SYMMETRIC) and name != "nb_own":
                    start = node.extent.start.offset
                    first, mid, last = (a.extent.start.offset, a.extent.end.offset, b.extent.start.offset)
                    self.add(node, self.text[start:first] + self.of(b) + self.text[mid:last] + self.of(a) + self.text[b.extent.end.offset:node.extent.end.offset])
            if name in OPPOSITE:
                self.add(node, self.of(node).replace(name, OPPOSITE[name], 1))
            for a in given:
                self.scaled(a)
        elif kind == Kind.VAR_DECL and children:
            if "=" in self.of(node) and node.storage_class != clang.StorageClass.STATIC:
                self.scaled(children[-1])
        elif kind == Kind.RETURN_STMT and children:
            value = children[0]
            if self.result == TypeKind.BOOL:
                self.add(value, "!(" + self.of(value) + ")")
            elif self.result in INTEGERS | {TypeKind.ENUM} and self.of(value) != "NB_OK":
                self.add(value, "0")
            elif self.result in REALS:
                self.add(value, "-(" + self.of(value) + ")")
                self.scaled(value)
        if kind in (Kind.IF_STMT, Kind.WHILE_STMT, Kind.CONDITIONAL_OPERATOR) and children:
            condition = children[0]
            simple = not re.search(r"&&|\|\||[<>=!]=|[^-]>|<", self.of(condition)) and not self.of(condition).startswith("!")
            if simple:
                self.add(condition, "!(" + self.of(condition) + ")")

    def scaled(self, node):
        """A real value becomes larger by a thousandth."""
        inner = node
        while inner.kind == Kind.UNEXPOSED_EXPR and list(inner.get_children()):
            inner = list(inner.get_children())[0]
        if inner.type.get_canonical().kind in REALS and inner.kind != Kind.FLOATING_LITERAL:
            text = self.of(node)
            product = not re.search(r"[-+<>=&|?]", re.sub(r"->|\([^()]*\)", "", text))
            self.add(node, "1.001 * " + (text if product else "(" + text + ")"))


def one_line(text):
    return " ".join(re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.S).split())


class Mutant:
    def __init__(self, number, site, file, span, new, text):
        start, end, self.statement = span
        first, last = text.rfind("\n", 0, start) + 1, (text + "\n").find("\n", end)
        self.number, self.site, self.file, self.new = number, site, file, new
        self.lines = (text.count("\n", 0, start) + 1, text.count("\n", 0, end) + 1)
        rest = text[end:last]
        if self.statement and rest.startswith(";") and not text[first:start].strip():
            self.changed = "deleted: " + one_line(text[first:last])
        else:
            self.changed = " ".join((text[first:start] + new + rest).split())

    def __str__(self):
        return f"{self.number} {self.file}:{self.lines[0]}: {self.changed}"


def with_schemata(text, spans, left_out):
    """Returns the text of a file in which every span of `spans`, {span: mutants}, chooses its mutants at run time."""
    order = sorted(spans, key=lambda s: (s[0], -s[1], not s[2]))

    def piece(start, end, k):
        out = []
        while k < len(order) and order[k][0] < end:
            span = order[k]
            out.append(text[start:span[0]])
            inner, k = piece(span[0], span[1], k + 1)
            mutants = [m for m in spans[span] if m.number not in left_out]
            if not mutants:
                out.append(inner)
            elif span[2]:
                m = mutants[0]
                out.append(f"(NB_SITE({m.site}) nb_mutant == {m.number} ? (void)0 : (void)({inner}))")
            else:
                choice = "".join(f"nb_mutant == {m.number} ? ({one_line(m.new)}) : " for m in mutants)
                out.append(f"(NB_SITE({mutants[0].site}) {choice}({inner}))")
            start = span[1]
        out.append(text[start:end])
        return "".join(out), k

    return piece(0, len(text), 0)[0]


# ---- the program with all mutants ------------------------------------------------------------------------------------


def objects_that_include(names):
    """Returns the object files of the build, with their sources, that depend on the files, as the compiler noted."""
    found = {}
    for target in (env["NINEBALL_OBJECTS"] + " " + env["LIBRARY_OBJECTS"]).split():
        folder, name = os.path.split(target)
        with open(f"{folder}/.deps/{os.path.splitext(name)[0]}.Po") as file:
            words = file.read().replace("\\\n", " ").split("\n")[0].split()
        needed = [os.path.relpath(os.path.abspath(w), source) for w in words[1:]]
        if set(needed) & set(names):
            found[target] = needed[0]
    return found


def make_program(module, names, work):
    """Writes `nineball` and `unit` with all mutants of the files to the folder; returns the mutants that compile."""
    compiler = shlex.split(env["COMPILE"])
    flags = [f for f in compiler[1:] if f[:2] in ("-I", "-D") or f.startswith("-std")]
    resource_dir = subprocess.run(["clang", "-print-resource-dir"], capture_output=True, text=True).stdout.strip()
    edits = {}
    for name in names:
        if name.endswith(".c"):
            Unit(os.path.join(source, name), set(names), flags + ["-I" + resource_dir + "/include", "-fopenmp"], edits)
    mutants, spans_of, texts, sites = [], {}, {}, 0
    for name in sorted(edits):
        with open(os.path.join(source, name), encoding="latin-1") as file:
            texts[name] = file.read()
        spans_of[name] = {}
        for span in sorted(edits[name]):
            spans_of[name][span] = [Mutant(len(mutants) + 1 + k, sites, name, span, new, texts[name]) for k, new in enumerate(edits[name][span])]
            mutants += spans_of[name][span]
            sites += 1
    if not mutants:
        stop(f"no file of `{module}` has mutants")
    tree = work + "/changed"
    shutil.rmtree(tree, ignore_errors=True)
    for part in ("src", "cases/refs"):
        shutil.copytree(os.path.join(source, part), os.path.join(tree, part))
    left_out = set()

    def write(name):
        with open(os.path.join(tree, name), "w", encoding="latin-1") as file:
            file.write(with_schemata(texts[name], spans_of[name], left_out))

    for name in texts:
        write(name)
    wanted = objects_that_include(texts)
    head = [compiler[0], "-I" + tree + "/src", "-I" + tree + "/cases/refs", *compiler[1:], "-w", "-O1", "-include", source + "/tests/mutants/schemata.h"]
    made = {}

    def compile_(target):
        made[target] = f"{work}/{target.replace('/', '-')}"
        return target, subprocess.run([*head, "-c", os.path.join(tree, wanted[target]), "-o", made[target]], capture_output=True, text=True,
                                      env={**env, "LC_ALL": "C"})

    targets = sorted(wanted)
    for _ in range(12):
        with concurrent.futures.ThreadPoolExecutor(int(env.get("JOBS") or 1)) as pool:
            results = list(pool.map(compile_, targets))
        failed = [(t, r) for t, r in results if r.returncode]
        if not failed:
            break
        before = len(left_out)
        for _, result in failed:
            for path, line in re.findall(r"^(\S+?):(\d+):\d+: (?:fatal )?error", result.stderr, re.M):
                name = os.path.relpath(os.path.abspath(path), tree)
                left_out |= {m.number for m in mutants if m.file == name and m.lines[0] <= int(line) <= m.lines[1]}
        if len(left_out) == before:
            stop(f"{failed[0][0]} does not compile:\n{failed[0][1].stderr[:2000]}")
        for name in texts:
            write(name)
        targets = [t for t, _ in failed]
    else:
        stop("the mutants do not compile")
    support = work + "/schemata.o"
    subprocess.run([*compiler, "-w", "-DNB_SITES_MOST=%d" % (sites + 1), "-c", source + "/tests/mutants/schemata.c", "-o", support], check=True)
    for program, objects in (("unit", env["UNIT_OBJECTS"]), ("nineball", env["NINEBALL_OBJECTS"])):
        listed = objects.split()
        first = [made.get(o, o) for o in listed] + [made[o] for o in env["LIBRARY_OBJECTS"].split() if o in made]
        subprocess.run([*compiler, *first, support, "librefs.a", "libnineball.a", *shlex.split(env["LIBS"]), "-o", f"{work}/{program}"], check=True)
    return [m for m in mutants if m.number not in left_out], sites, len(left_out)


# ---- the checks ------------------------------------------------------------------------------------------------------


class Check:
    def __init__(self, name, command, folder=None, wanted=None):
        self.name, self.command, self.folder, self.wanted = name, command, folder, wanted
        self.seconds, self.reached = 0, b""

    def run(self, folder, mutant=0, sites=None, limit=None):
        """Runs the check; returns whether it passed, and its processor time."""
        def limits():
            if limit:
                resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 1, int(limit) + 2))
                resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
        given = {**env, "NB_MUTANT": str(mutant), "NINEBALL": work + "/nineball", "srcdir": source}
        given.pop("NB_SITES", None)
        if sites:
            given["NB_SITES"] = sites
        with tempfile.TemporaryFile() as output:
            stdout, stderr = (subprocess.DEVNULL, output) if self.wanted else (output, subprocess.DEVNULL)
            process = subprocess.Popen(self.command, cwd=self.folder or folder, stdin=subprocess.DEVNULL, stdout=stdout, stderr=stderr, env=given,
                                       start_new_session=True, preexec_fn=limits)
            began, ended = time.time(), 0
            while not ended:
                ended, status, used = os.wait4(process.pid, os.WNOHANG)
                if not ended and limit and time.time() - began > 20 * limit + 60: # it waits for something
                    os.killpg(process.pid, signal.SIGKILL)
                if not ended:
                    time.sleep(0.01)
            process.returncode = os.waitstatus_to_exitcode(status)
            output.seek(0)
            said = output.read()
        passed = process.returncode == 2 and said == self.wanted if self.wanted else process.returncode == 0 and not re.search(rb"^not ok", said, re.M)
        return passed, used.ru_utime + used.ru_stime


def all_checks():
    checks = []
    with open("suites-register.h") as file:
        for suite in re.findall(r"NB_SUITE\((\w+)\)", file.read()):
            checks.append(Check("suite " + suite, [work + "/unit", suite]))
    for page in sorted(glob.glob("tests/bad/*.md", root_dir=source)):
        with open(os.path.join(source, page), "rb") as file:
            block = re.search(rb"^```mistake(.*?)\n(.*?)^```$", file.read().replace(b"\r", b""), re.M | re.S)
        if block:
            command = f'"$NINEBALL" explain {block[1].decode()} "$0"'
            checks.append(Check(page, ["sh", "-c", command, page], source, block[2]))
    also = env.get("ALSO", "").split()
    for page in env["NB_PAGES"].split() if "cases" in also else []:
        checks.append(Check(page, [work + "/nineball", "check", "--tap", os.path.join(source, page)]))
    for script in [a for a in also if a != "cases"]:
        checks.append(Check(script + ".sh", ["sh", f"{source}/tests/{script}.sh"]))
    return checks


def record(checks, sites, jobs):
    """Runs every check without a mutant, and keeps those that pass with their time and the sites that they reach. The
    result is kept until the program changes."""
    key = hashlib.sha256()
    for program in ("unit", "nineball"):
        with open(f"{work}/{program}", "rb") as file:
            key.update(file.read())
    try:
        with open(work + "/record.json") as file:
            known = json.load(file)
    except (OSError, ValueError):
        known = {}
    if known.get("program") != key.hexdigest():
        known = {"program": key.hexdigest()}

    def one(check):
        if check.name not in known:
            folder = folders.get()
            with open(folder + "/sites", "wb") as file:
                file.write(bytes(sites + 1))
            passed, seconds = check.run(folder, sites=folder + "/sites")
            with open(folder + "/sites", "rb") as file:
                known[check.name] = passed, seconds, file.read().hex()
            folders.put(folder)
        passed, check.seconds, reached = known[check.name]
        check.reached = bytes.fromhex(reached)
        if not passed:
            print(f"mutants: {check.name} fails without a mutant and is not used", flush=True)
        return passed

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        kept = [check for check, passed in zip(checks, pool.map(one, checks)) if passed]
    with open(work + "/record.json", "w") as file:
        json.dump(known, file)
    return sorted(kept, key=lambda c: c.seconds)


# ---- one after the other ---------------------------------------------------------------------------------------------


def main():
    global work, folders
    module, sample, seed = env["MODULE"], env.get("SAMPLE") or "50", env.get("SEED") or "1"
    modules, equal = read_rules()
    names = files_of(module, modules)
    if not names:
        stop(f"no module and no file `{module}`; modules: {', '.join(modules)}")
    work, jobs = f"{build}/mutants/{module.replace('/', '-')}", int(env.get("JOBS") or 1)
    os.makedirs(work, exist_ok=True)
    folders = queue.Queue()
    for k in range(jobs):
        os.makedirs(f"{work}/run{k}", exist_ok=True)
        folders.put(f"{work}/run{k}")
    for name in os.listdir(source): # tests look for their pages in `..` if they were built to do so
        if name in ("cases", "tests", "docs", "plots", "src", "README.md", "HACKING.md", "NEWS", "build-aux", ".ci", "Makefile.am") and not os.path.lexists(f"{work}/{name}"):
            os.symlink(os.path.join(source, name), f"{work}/{name}")
    mutants, sites, left_out = make_program(module, names, work)
    print(f"mutants: {module}: {len(mutants)} mutants in {len(names)} files, {left_out} do not compile", flush=True)
    began = time.time()
    checks = record(all_checks(), sites, jobs)
    print(f"mutants: {len(checks)} checks recorded in {time.time() - began:.0f} s", flush=True)
    if env.get("MUTANT"):
        chosen = [m for m in mutants if m.number in map(int, env["MUTANT"].split())]
    elif sample == "all":
        chosen = mutants
    else:
        chosen = random.Random(seed).sample(mutants, min(int(sample), len(mutants)))

    def try_(m):
        if (m.file, m.changed) in equal:
            return m, "equal", "equivalent, see tests/mutants/rules.txt"
        reaching = [c for c in checks if c.reached[m.site]]
        folder = folders.get()
        by = next((c.name for c in reaching if not c.run(folder, m.number, limit=3 * c.seconds + 2)[0]), None)
        folders.put(folder)
        return m, "killed" if by else "survives", by or ("SURVIVES" if reaching else "SURVIVES, no check reaches it")

    count, survivors = {"killed": 0, "survives": 0, "equal": 0}, []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for m, result, by in pool.map(try_, chosen):
            count[result] += 1
            print(f"{m}\n      {by}", flush=True)
            if result == "survives":
                survivors.append(f"{m}{' # not reached' if by.endswith('it') else ''}")
    print(f"mutants: {count['killed']} killed, {count['survives']} survived, {count['equal']} equivalent")
    for m in survivors:
        print("survived: " + m)
    sys.exit(1 if survivors else 0)


main()
