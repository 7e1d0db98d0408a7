#!/usr/bin/env bash
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# check.sh SOURCE BUILD WORK: installs what was built in BUILD below WORK, as a folder and as Debian packages, and uses
# the program from there in a repository that is not the checkout: its snapshots agree with their references, a changed
# level is found, and the program tells what was installed.

set -euo pipefail
readonly source=$1 build=$2 work=$3

rm -rf "$work"
mkdir -p "$work"
cp -r "$source/tests/own_repository" "$work/repository"

Check() {  # PREFIX
    local program=$1/bin/scree output
    cd "$work/repository"
    echo "== $program"
    output=$("$program" --version)
    [[ $output == "scree "*", commit "* ]] || { echo "--version says: $output"; exit 1; }
    output=$("$program" env)
    for word in "$program" "$1/include/scree_capture.h" "$1/share/man/man1/scree.1"; do
        [[ $output == *"$word"* ]] || { echo "$word is not in: $output"; exit 1; }
    done
    for command in "" -find -snapshot; do
        MANROFFOPT=-ww MANPAGER=cat MANWIDTH=100 man -l "$1/share/man/man1/scree$command.1" >"$work/page" 2>"$work/warnings"
        [[ ! -s $work/warnings ]] || { cat "$work/warnings"; exit 1; }
        grep -q "EXIT STATUS" "$work/page"
    done

    echo "== its snapshots agree"
    "$program" snapshot check --scenes levels --report report --junit snapshots.xml
    grep -q 'failures="0"' snapshots.xml
    mv levels/references elsewhere
    "$program" snapshot check --scenes levels --references elsewhere
    mv elsewhere levels/references
    echo "== a level was changed"
    sed -i 's/"linearVelocity": \[14, 1\]/"linearVelocity": [13, 1]/' levels/tower.scene.json
    local code=0
    "$program" snapshot check --scenes levels --report report >"$work/output" || code=$?
    ((code == 1)) && grep -q "tower/step-0120-render" "$work/output" && [[ -s report/index.html ]]
    echo "== it is accepted by the command that the report names"
    eval "$(sed -n 's/.*\(scree snapshot update .*step-0120-render.*\)$/\1/p' "$work/output" | head -1 |
        sed "s|^scree|'$program'|")"
    code=0
    "$program" snapshot check --scenes levels -g 'step-0120-render' || code=$?
    ((code == 0))
    rm -rf "$work/repository"
    cp -r "$source/tests/own_repository" "$work/repository"
}

cmake --install "$build" --prefix "$work/first" >/dev/null
mv "$work/first" "$work/prefix"  # an installed tree can be moved
Check "$work/prefix"

echo "== as Debian packages"
(cd "$build" && cpack -G DEB -B "$work/package" >"$work/cpack.txt") || { cat "$work/cpack.txt"; exit 1; }
for package in scree libscree-dev; do dpkg-deb -x "$work"/package/"$package"_*.deb "$work/unpacked"; done
dpkg-deb -I "$work"/package/scree_*.deb | grep -E "Depends: .*libc6"
Check "$work/unpacked/usr"
