"""Builds the Python package with CMake, without a network: what `pip` and `build` call (PEP 517).

    python3 -m build --no-isolation            an sdist and a wheel in dist/
    pip install .                              with the build tools and -dev packages of ./dev

Settings (--config-setting NAME=VALUE): `build-dir`, a build folder to use and to keep instead of
one for this time; `built`, a build folder whose package is taken as it is.
"""

from __future__ import annotations

import base64
import hashlib
import io
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

root = pathlib.Path(__file__).resolve().parent.parent
name = "changeover"


def version() -> str:
    found = re.search(r"project\(changeover\s+VERSION (\S+)", (root / "CMakeLists.txt").read_text())
    if not found:
        raise RuntimeError("CMakeLists.txt: no version")
    return found.group(1)


def listed(name: str) -> list[str]:
    """The texts of a list in pyproject.toml. (Python has a reader of TOML from 3.11 on only.)"""
    text = (root / "pyproject.toml").read_text(encoding="utf-8")
    found = re.search(rf"^{name} = \[(.*?)^\]", text, re.M | re.S)
    if not found:
        raise RuntimeError(f"pyproject.toml: no list '{name}'")
    return re.findall(r'"([^"]+)"', found.group(1))


def metadata() -> str:
    classifiers = "".join(f"Classifier: {each}\n" for each in listed("classifiers"))
    return (
        f"Metadata-Version: 2.1\nName: {name}\nVersion: {version()}\n"
        "Summary: Finds, verifies and draws change covering designs\n"
        "License: MIT\nAuthor: The Changeover developers\nRequires-Python: >=3.9\n"
        f"Keywords: {','.join(listed('keywords'))}\n{classifiers}"
        "Description-Content-Type: text/markdown\n\n" + (root / "docs/python.md").read_text()
    )


def sources() -> list[str]:
    """The files of a source archive: what git knows, or without git all but what builds leave."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=root, capture_output=True, text=True)
    if (root / ".git").exists() and listed.returncode == 0:
        return sorted(
            path for path in listed.stdout.split("\0") if path and (root / path).is_file()
        )
    left = {"build", "dist", "node_modules", "__pycache__", ".git"}
    found = []
    for folder, folders, files in os.walk(root):
        folders[:] = [
            each
            for each in folders
            if each not in left or pathlib.Path(folder, each) == root / "web/dist"
        ]
        found += [str(pathlib.Path(folder, file).relative_to(root)) for file in files]
    return sorted(path for path in found if path != "PKG-INFO")


def build_sdist(sdist_directory: str, config_settings: dict | None = None) -> str:
    stem = f"{name}-{version()}"
    archive = pathlib.Path(sdist_directory, stem + ".tar.gz")
    with tarfile.open(archive, "w:gz", format=tarfile.PAX_FORMAT) as tar:
        text = metadata().encode()
        info = tarfile.TarInfo(f"{stem}/PKG-INFO")
        info.size = len(text)
        tar.addfile(info, io.BytesIO(text))
        for path in sources():
            tar.add(root / path, f"{stem}/{path}", recursive=False)
    return archive.name


def built(folder: pathlib.Path) -> pathlib.Path:
    """The package as CMake makes it, in a build folder."""
    configure = [
        "cmake", "-S", str(root), "-B", str(folder), f"-DPython_EXECUTABLE={sys.executable}",
    ]
    if not (folder / "CMakeCache.txt").exists():
        configure += ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
    for command in (
        configure,
        ["cmake", "--build", str(folder), "--target", "changeover_python_package"],
    ):
        if subprocess.run(command, stdout=sys.stderr).returncode != 0:
            raise RuntimeError(
                "CMake failed; what it lacks is said above, and ./dev setup installs it on Debian"
            )
    return folder / "python" / name


def build_wheel(
    wheel_directory: str, config_settings: dict | None = None, metadata_directory: str | None = None
) -> str:
    tag = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    stem = f"{name}-{version()}"
    wheel = pathlib.Path(wheel_directory, f"{stem}-{tag}-{tag}-{platform}.whl")
    settings = config_settings or {}
    with tempfile.TemporaryDirectory() as temporary:
        if "built" in settings:
            package = pathlib.Path(settings["built"], "python", name)
        else:
            package = built(pathlib.Path(settings.get("build-dir", temporary)))
        files = {
            f"{name}/{path.relative_to(package)}": path.read_bytes()
            for path in sorted(package.rglob("*"))
            if path.suffix in {".py", ".pyi", ".so", ".typed"} or path.name == "py.typed"
        }
    info = f"{stem}.dist-info"
    files[f"{info}/METADATA"] = metadata().encode()
    files[f"{info}/LICENSE"] = (root / "LICENSE").read_bytes()
    files[f"{info}/WHEEL"] = (
        "Wheel-Version: 1.0\nGenerator: changeover\nRoot-Is-Purelib: false\n"
        f"Tag: {tag}-{tag}-{platform}\n"
    ).encode()
    record = ""
    for path, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{path},sha256={digest},{len(content)}\n"
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in files.items():
            entry = zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
            archive.writestr(entry, content)
    return wheel.name
