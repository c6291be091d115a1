"""Which files of a checkout are the project's own: what git tracks or would, and everything but build/ where git is no help."""
import os
import pathlib
import subprocess


def project_files(root):
    root = pathlib.Path(root)
    command = ["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    try:
        listing = subprocess.run(command, capture_output=True, check=True).stdout
        found = [root / os.fsdecode(name) for name in listing.split(b"\0") if name]
    except (OSError, subprocess.CalledProcessError):
        found = []
    if not found:
        for folder, folders, names in os.walk(root):
            folders[:] = [name for name in folders if name not in (".git", "build", ".cache")]
            found += [pathlib.Path(folder) / name for name in names]
    return sorted(path for path in found if path.is_file() and not path.is_symlink())


def cpp_files(root):
    return [path for path in project_files(root) if path.suffix in (".hpp", ".cpp")]
