#!/usr/bin/env python3
"""bill_of_materials.py PROGRAM: what a program is linked with, as SPDX 2.3 in JSON.

Each library's Debian package is listed with its version and the license that Debian states: shared
libraries, and those that are compiled into the program.
"""

import datetime
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

# Compiled into the program: its name in `changeover --version`, and a file of its Debian package.
COMPILED_IN = {
    "CaDiCaL": "libcadical.a",
    "CLI11": "/usr/include/CLI/CLI.hpp",
    "nlohmann_json": "/usr/include/nlohmann/json.hpp",
}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def package_of(library):
    """The package of a file; Debian knows some files by their place before /usr was merged."""
    for place in (library, os.path.realpath(library), library.removeprefix("/usr")):
        found = subprocess.run(["dpkg-query", "--search", place], capture_output=True, text=True)
        if found.returncode == 0:
            return found.stdout.split(": ")[0].split(",")[0]
    raise SystemExit(f"bill_of_materials: no package has {library}")


def machine_of(file):
    """The word size and the processor of an ELF file."""
    with open(file, "rb") as binary:
        header = binary.read(20)
    return header[4], header[18:20]


def license_of(package):
    """What the package's copyright file, if a program can read it, states of most files."""
    file = pathlib.Path("/usr/share/doc", package, "copyright")
    if not file.exists():
        return None
    text = file.read_text(encoding="utf-8", errors="replace")
    found = re.search(r"^Files: \*$.*?^License: *(\S.*?)$", text, re.MULTILINE | re.DOTALL)
    return found and found[1]


def compiled_in(program):
    """The packages of COMPILED_IN that the program says it was built with."""
    built_with = json.loads(output(program, "--version", "--json"))["libraries"]
    for name, file in COMPILED_IN.items():
        if name not in built_with:
            raise SystemExit(f"bill_of_materials: {program} --version has no {name}")
        if not file.startswith("/"):
            file = output("g++", f"-print-file-name={file}").strip()
        yield package_of(file)


def main(program):
    libraries = set(re.findall(r"=> (/\S+)", output("ldd", program)))
    # What the program loads late is in it by its name, as a separate string.
    names = set(re.findall(rb"\0(lib[a-z]+\.so\.[0-9]+)\0", pathlib.Path(program).read_bytes()))
    for name, place in re.findall(r"(\S+) \([^)]*\) => (/\S+)", output("/sbin/ldconfig", "-p")):
        if name.encode() in names and machine_of(place) == machine_of(program):
            libraries |= {place, *re.findall(r"=> (/\S+)", output("ldd", place))}
    links = {package: "STATIC_LINK" for package in compiled_in(program)}
    links |= {package_of(library): "DYNAMIC_LINK" for library in libraries}
    version = output(program, "--version").split()[1]
    when = os.environ.get("SOURCE_DATE_EPOCH") or output("git", "log", "-1", "--format=%ct")
    created = datetime.datetime.fromtimestamp(int(when), datetime.timezone.utc).strftime(
        "%Y-%m-%dT%H:%M:%SZ"
    )
    digest = hashlib.sha256(pathlib.Path(program).read_bytes()).hexdigest()
    described = [
        {
            "SPDXID": "SPDXRef-changeover",
            "name": "changeover",
            "versionInfo": version,
            "downloadLocation": "NOASSERTION",
            "filesAnalyzed": False,
            "licenseDeclared": "MIT",
            "supplier": "Organization: The Changeover developers",
            "checksums": [{"algorithm": "SHA256", "checksumValue": digest}],
        }
    ]
    relations = [
        {
            "spdxElementId": "SPDXRef-DOCUMENT",
            "relationshipType": "DESCRIBES",
            "relatedSpdxElement": "SPDXRef-changeover",
        }
    ]
    for package, link in sorted(links.items()):
        name, number, source = output(
            "dpkg-query", "--show", "--showformat=${Package} ${Version} ${source:Package}", package
        ).split()
        license = license_of(name)
        identity = "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)
        described.append(
            {
                "SPDXID": identity,
                "name": name,
                "versionInfo": number,
                "sourceInfo": f"Debian source package {source}",
                "downloadLocation": "NOASSERTION",
                "filesAnalyzed": False,
            }
            | ({"licenseComments": f"Debian states {license} for Files: *"} if license else {})
        )
        relations.append(
            {
                "spdxElementId": "SPDXRef-changeover",
                "relationshipType": link,
                "relatedSpdxElement": identity,
            }
        )
    json.dump(
        {
            "spdxVersion": "SPDX-2.3",
            "dataLicense": "CC0-1.0",
            "SPDXID": "SPDXRef-DOCUMENT",
            "name": f"changeover-{version}",
            "documentNamespace": f"urn:changeover:{version}:{digest}",
            "creationInfo": {
                "created": created,
                "creators": ["Organization: The Changeover developers"],
            },
            "packages": described,
            "relationships": relations,
        },
        sys.stdout,
        indent=1,
    )
    print()


main(sys.argv[1])
