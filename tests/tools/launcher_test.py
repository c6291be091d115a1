#!/usr/bin/env python3
"""./kerf and ./test as a fresh machine sees them, with made-up package tools in front of the real ones."""
import os
import pathlib
import pwd
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = {
    # Everything is installed but what stands in the file `absent`.
    "dpkg-query": 'echo asked >>"$FAKE/dpkg-query.log"\n'
                  'for name; do :; done\ngrep -qxF -- "$name" "$FAKE/absent" && exit 1\nprintf installed\n',
    "apt-get": 'echo "$@" >>"$FAKE/apt-get.log"\ncase " $* " in *" update "*) touch "$FAKE/lists"; exit 0 ;; esac\n'
               '[ -e "$FAKE/lists" ] || { echo "E: no lists"; exit 100; }\n[ -e "$FAKE/offline" ] && exit 100\n: >"$FAKE/absent"\n',
    "cmake": 'echo configuring\nprintf "%s\\n" "$@" >>"$FAKE/cmake.log"\nmkdir -p build/release\n: >build/release/build.ninja\n'
             'echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/release/CMakeCache.txt\n',
    "ninja": 'echo building\n[ -e "$FAKE/broken" ] && { echo "kerf.cpp:1:1: error: oh"; exit 1; }\nmkdir -p "$2/programs"\n'
             'printf "#!/bin/sh\\nprintf \\"%%s|\\" \\"\\$PWD\\" \\"\\$@\\"\\nexit 4\\n" >"$2/programs/kerf"\nchmod +x "$2/programs/kerf"\n',
    "ctest": 'printf "ctest %s\\n" "$*"\nexit 8\n',
    "sudo": '[ -e "$FAKE/nosudo" ] && exit 1\n[ "$1" = -n ] && shift\necho "$@" >>"$FAKE/sudo.log"\nexec "$@"\n',
}


class Launcher(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="a fresh clone "))
        self.addCleanup(shutil.rmtree, self.folder)
        self.clone, self.fake = self.folder / "kerf here", self.folder / "fake"
        (self.clone / "scripts").mkdir(parents=True)
        self.fake.mkdir()
        for name in ("kerf", "test", "scripts/prepare.bash"):
            shutil.copy2(ROOT / name, self.clone / name)
        for name, body in TOOLS.items():
            (self.fake / name).write_text("#!/bin/sh\n" + body)
            (self.fake / name).chmod(0o755)
        (self.fake / "absent").write_text("")
        self.open_to_all()

    def open_to_all(self):
        for path in (self.folder, *self.folder.rglob("*")):
            path.chmod(0o777)

    def run_script(self, name, *arguments, user=None, cwd=None):
        self.open_to_all()
        environment = {**os.environ, "FAKE": str(self.fake), "PATH": f"{self.fake}:/usr/bin:/bin"}
        return subprocess.run([self.clone / name, *arguments], capture_output=True, text=True, check=False, env=environment,
                              cwd=cwd or self.folder, user=user, stdin=subprocess.DEVNULL)

    def log(self, tool):
        path = self.fake / (tool + ".log")
        return path.read_text().splitlines() if path.exists() else []

    def absent(self, *names):
        (self.fake / "absent").write_text("".join(name + "\n" for name in names))

    def ordinary_user(self):
        if os.geteuid() != 0:
            return None
        return pwd.getpwnam("nobody").pw_uid

    def test_kerf_builds_and_hands_over_arguments_folder_status_and_a_clean_output(self):
        result = self.run_script("kerf", "dry-run", "a b.ngc", "--json")
        self.assertEqual(result.stdout, f"{self.folder}|dry-run|a b.ngc|--json|")
        self.assertEqual(result.returncode, 4)

    def test_kerf_configures_and_asks_for_packages_only_once(self):
        self.run_script("kerf")
        asked, configured = len(self.log("dpkg-query")), len(self.log("cmake"))
        self.assertGreater(asked, 5)
        again = self.run_script("kerf")
        self.assertEqual((len(self.log("dpkg-query")), len(self.log("cmake"))), (asked, configured))
        self.assertEqual(again.stderr, "")

    def test_kerf_configures_anew_where_the_clone_was_moved(self):
        self.run_script("kerf")
        moved = self.folder / "elsewhere"
        self.clone = self.clone.rename(moved)
        configured = len(self.log("cmake"))
        self.run_script("kerf")
        self.assertGreater(len(self.log("cmake")), configured)
        self.assertIn("--fresh", self.log("cmake"))

    def test_a_link_from_elsewhere_finds_the_clone(self):
        link = self.folder / "link"
        link.symlink_to(self.clone / "kerf")
        result = subprocess.run([link, "x"], capture_output=True, text=True, check=False, cwd=self.fake,
                                env={**os.environ, "FAKE": str(self.fake), "PATH": f"{self.fake}:/usr/bin:/bin"})
        self.assertEqual(result.stdout, f"{self.fake}|x|")

    @unittest.skipUnless(os.geteuid() == 0, "needs root")
    def test_root_installs_what_is_missing_and_fetches_the_lists_when_it_must(self):
        self.absent("libeigen3-dev", "ninja-build")
        result = self.run_script("kerf")
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertEqual(["update" in line for line in self.log("apt-get")], [False, True, False])
        self.assertIn("--no-install-recommends ninja-build libeigen3-dev", self.log("apt-get")[-1])
        self.assertEqual(self.log("sudo"), [])

    def test_an_ordinary_user_installs_with_sudo(self):
        self.absent("libeigen3-dev")
        (self.fake / "lists").touch()
        result = self.run_script("kerf", user=self.ordinary_user())
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("DEBIAN_FRONTEND=noninteractive apt-get", self.log("sudo")[-1])

    def test_without_root_and_sudo_the_missing_packages_are_named(self):
        self.absent("libeigen3-dev", "ninja-build")
        (self.fake / "nosudo").touch()
        for script in ("kerf", "test"):
            result = self.run_script(script, user=self.ordinary_user())
            self.assertEqual((result.returncode, result.stdout), (125, ""))
            self.assertIn("missing: ninja-build libeigen3-dev", result.stderr)
            self.assertIn("apt-get install --no-install-recommends ninja-build libeigen3-dev", result.stderr)

    @unittest.skipUnless(os.geteuid() == 0, "needs root")
    def test_without_a_network_the_missing_packages_are_named(self):
        self.absent("libeigen3-dev")
        (self.fake / "offline").touch()
        result = self.run_script("kerf")
        self.assertEqual(result.returncode, 125)
        self.assertIn("could not be installed: libeigen3-dev", result.stderr)

    def test_a_build_that_fails_shows_why_and_runs_nothing(self):
        (self.fake / "broken").touch()
        result = self.run_script("kerf", "dry-run")
        self.assertEqual((result.returncode, result.stdout), (125, ""))
        self.assertIn("kerf.cpp:1:1: error: oh", result.stderr)

    def test_test_needs_its_own_packages_and_gives_the_status_of_ctest(self):
        self.absent("libgtest-dev")
        (self.fake / "nosudo").touch()
        self.assertEqual(self.run_script("test", user=self.ordinary_user()).returncode, 125)
        self.absent()
        result = self.run_script("test", "release", "-R", "a b")
        self.assertEqual(result.returncode, 8)
        self.assertRegex(result.stdout, r"ctest --test-dir .*/build/release .* -R a b\n")
        self.assertIn("-DKERF_TESTS=ON", self.log("cmake"))

    def test_test_refuses_a_preset_that_is_none(self):
        result = self.run_script("test", "fast")
        self.assertEqual(result.returncode, 2)
        self.assertIn("release, asan, tsan, lto", result.stderr)


if __name__ == "__main__":
    unittest.main()
