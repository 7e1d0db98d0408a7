#!/usr/bin/env bash
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# check.sh SOURCE WORK COMPILER BUILD: installs what was built in BUILD below WORK, and builds and runs programs outside the
# project against it: one found by find_package(scree) and by pkg-config, one written for Box2D, and one that records its
# world; the first also against the unpacked Debian packages. Fails too if the engine's library defines Box2D's names or needs anything but the C++ runtime. Where BUILD is
# `alone`, the engine is first built by itself, as shared libraries: several minutes without a cache of the compiler.

set -euo pipefail
readonly source=$1 work=$2 compiler=$3 build=$4
readonly consumer=$source/tests/architecture/install

rm -rf "$work"
mkdir -p "$work"
options=(-G Ninja -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_COMPILER=$compiler")
if command -v ccache >/dev/null; then options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

echo "== the engine alone, without what the testbed needs"
# No optimisation: what is tested is that it builds, installs and links.
cmake -S "$source" -B "$work/engine" "${options[@]}" -DCMAKE_CXX_FLAGS_DEBUG=-O0 \
    -DSCREE_BUILD_TESTBED=OFF -DSCREE_BUILD_TESTS=OFF -DBUILD_SHARED_LIBS=ON
if [[ $build == alone ]]; then
    cmake --build "$work/engine"
    cmake --install "$work/engine" --prefix "$work/first"
else
    cmake --install "$build" --prefix "$work/first"
fi
mv "$work/first" "$work/prefix"  # an installed tree can be moved

echo "== as Debian packages"
built=$build
[[ $build != alone ]] || built=$work/engine
(cd "$built" && cpack -G DEB -B "$work/packages" >"$work/cpack.txt") || { cat "$work/cpack.txt"; exit 1; }
for package in "$work"/packages/libscree*.deb; do dpkg-deb -x "$package" "$work/unpacked"; done
if [[ $build == alone ]]; then
    dpkg-deb -I "$work"/packages/libscree-dev_*.deb | grep -E '^ Depends: libscree[0-9.]+ \(= '
    dpkg-deb -I "$work"/packages/libscree[0-9]*.deb | grep -E '^ Depends: .*libstdc\+\+6'
fi
cmake -S "$consumer" -B "$work/consumer-of-package" "${options[@]}" "-DCMAKE_PREFIX_PATH=$work/unpacked/usr"
cmake --build "$work/consumer-of-package" --target consumer
"$work/consumer-of-package/consumer"

echo "== no Box2D names, no libraries but the runtime"
library=$(find "$work/prefix" -name 'libscree.so' -o -name 'libscree.a')
if [[ $library == *.a ]]; then
    shared=$work/libscree-whole.so
    "$compiler" -shared -Wl,--whole-archive "$library" -Wl,--no-whole-archive -Wl,--no-undefined -o "$shared"
else
    shared=$library
    # The name that programs are linked with holds major and minor version: a new minor version may change the interface.
    version=$(sed -n 's/^Version: \([0-9]*\.[0-9]*\).*/\1/p' "$(find "$work/prefix" -name scree.pc)")
    objdump -p "$shared" | grep -qE "SONAME +libscree\.so\.${version//./\\.}$"
    "$source/tests/exports/check.py" clang++ "$source" "$shared"
fi
if nm -DC --defined-only "$shared" | grep -E '\bb2[A-Z]'; then exit 1; fi
if objdump -p "$shared" | awk '/NEEDED/ {print $2}' |
    grep -vE '^(libstdc\+\+|libm|libgcc_s|libc|ld-linux[a-z0-9-]*)\.so'; then exit 1; fi

echo "== find_package(scree)"
cmake -S "$consumer" -B "$work/consumer" "${options[@]}" "-DCMAKE_PREFIX_PATH=$work/prefix"
cmake --build "$work/consumer"
"$work/consumer/consumer"
"$work/consumer/consumer_box2d"
(cd "$work" && "$work/consumer/consumer_capture" && [[ -s session.track && -s level.scene.json ]])

echo "== pkg-config"
PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name scree.pc)")
export PKG_CONFIG_PATH
read -ra flags <<<"$(pkg-config --cflags --libs scree)"
"$compiler" "$consumer/consumer.cpp" "${flags[@]}" "-Wl,-rpath,$(dirname "$library")" -o "$work/with-pkg-config"
"$work/with-pkg-config"
read -ra compat <<<"$(pkg-config --cflags --libs scree_box2d)"
[[ " ${compat[*]} " == *" -std=c++20 "* ]]
"$compiler" "$consumer/consumer_box2d.cpp" "${compat[@]}" "-Wl,-rpath,$(dirname "$library")" -o "$work/box2d-with-pkg-config"
"$work/box2d-with-pkg-config"

echo "== a program with flags of its own"
own=(-O2 -ffast-math)
if [[ $(uname -m) == x86_64 ]] && grep -qw fma /proc/cpuinfo; then own+=(-mfma -mavx2); fi
"$compiler" "${own[@]}" "$consumer/consumer.cpp" "${flags[@]}" "-Wl,-rpath,$(dirname "$library")" -o "$work/with-own-flags"
diff <("$work/with-pkg-config") <("$work/with-own-flags")  # the same state

echo "== an older standard is told"
if "$compiler" "${flags[@]}" -std=c++17 -fsyntax-only "$consumer/consumer.cpp" 2>"$work/older"; then exit 1; fi
grep -q 'Scree needs C++20' "$work/older"

echo "== an engine that is not exact is refused"
for file in "$source"/engine/src/base/task_pool.cpp "$source"/engine/src/constraints/contact_kernels.cpp; do
    if "$compiler" -std=c++20 -ffast-math "-I$source/engine/include" "-I$source/engine/src" -fsyntax-only "$file" 2>"$work/fast"; then exit 1; fi
    grep -q 'compile it without -ffast-math' "$work/fast"
done
