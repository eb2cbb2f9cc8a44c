"""What the program writes as LaTeX compiles, and no line of it leaves the page.

    latex_compiles_test.py PROGRAM

Runs pdflatex on each answer twice, in a separate folder, and reads the log: no error, no box more
than ten points too wide, nothing that floats off its page. Without pdflatex (Debian:
texlive-latex-recommended) the test says so and is skipped; without TikZ (texlive-pictures) the
dossiers are left out. Neither is among the packages of ./dev test, for both are large.
"""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ANSWERS = {
    "table": ["table", "--k", "3..8", "--v", "5..30"],
    "wide-table": ["table", "--k", "3..20", "--v", "5..60"],
    "bounds": ["bounds", "40", "6", "--change", "2", "--circular"],
    "explain": ["explain", "23", "5", "--circular"],
    "minima": ["minima"],
    "design": ["design", "23", "5"],
    "long-design": ["design", "61", "4", "--circular"],
}
DOSSIERS = {
    "dossier": ["dossier", "23", "5", "--circular"],
    "dossier-of-label": ["dossier", "26.4.2.circular.65"],
    "dossier-of-base-blocks": ["dossier", "61", "4", "--circular"],
    "dossier-of-large-blocks": ["dossier", "80", "36", "--circular"],
    "dossier-of-many-large-blocks": ["dossier", "150", "30", "--circular"],
    "dossier-without-blocks": ["dossier", "300", "45", "--circular"],
}
MOST_POINTS = 10.0
AROUND = (
    "\\documentclass{article}\n\\usepackage[T1]{fontenc}\n\\usepackage{booktabs,longtable}\n"
    "\\begin{document}\n%s\n\\end{document}\n"
)


def faults_in(log: str) -> list[str]:
    """What a log of LaTeX tells of errors and of what does not fit, a line each."""
    found = re.findall(r"^! .*$", log, re.MULTILINE)
    for points, where in re.findall(r"^Overfull \\hbox \(([\d.]+)pt too wide\)(.*)$", log, re.M):
        if float(points) > MOST_POINTS:
            found.append(f"{points} points too wide{where}")
    return found + re.findall(r"^LaTeX Warning: Float too large.*$", log, re.MULTILINE)


def compiled(text: str, folder: Path) -> list[str]:
    """The faults of a document."""
    (folder / "it.tex").write_text(text, encoding="utf-8")
    for _ in range(2):  # longtable needs the widths of the first run
        subprocess.run(
            ["pdflatex", "-interaction=nonstopmode", "it.tex"],
            cwd=folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,  # fonts that are made
            check=False,
            timeout=120,
        )
    return faults_in((folder / "it.log").read_text(encoding="utf-8", errors="replace"))


def main() -> int:
    program = sys.argv[1]
    if shutil.which("pdflatex") is None:
        print("skipped: there is no pdflatex (Debian: texlive-latex-recommended)")
        return 77
    wanted = dict(ANSWERS)
    if subprocess.run(["kpsewhich", "tikz.sty"], capture_output=True, check=False).returncode == 0:
        wanted |= DOSSIERS
    else:
        print("dossiers are left out: there is no tikz.sty (Debian: texlive-pictures)")
    # A check that cannot fail is none.
    with tempfile.TemporaryDirectory() as folder:
        for wrong in (r"\nothing", r"\noindent\rule{400pt}{1pt}"):
            assert compiled(AROUND % wrong, Path(folder)), f"{wrong} was not seen"
    failed = 0
    for name, arguments in wanted.items():
        answer = subprocess.run(
            [program, *arguments, "--format", "latex"], capture_output=True, text=True, check=True
        ).stdout
        with tempfile.TemporaryDirectory() as folder:
            whole = "\\documentclass" in answer
            for fault in compiled(answer if whole else AROUND % answer, Path(folder)):
                print(f"{name} ({' '.join(arguments)}): {fault}")
                failed = 1
    return failed


if __name__ == "__main__":
    sys.exit(main())
