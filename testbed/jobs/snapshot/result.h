// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a comparison of pictures found: one result per picture. `scree snapshot check --report DIR` and `scree diff -o
// DIR` write them to DIR/results.json, beside actual/, expected/ and diff/. Paths in it are relative to DIR.
//
//     {"schema": 1, "command": "scree snapshot check", "clean": false,
//      "renderer": {"backend": "osmesa", "gl_renderer": "llvmpipe …", "gl_version": "4.5 …"},
//      "cases": 172,
//      "counts": {"equal": 170, "changed": 1, "size": 0, "state": 0, "missing": 1, "new": 0, "deleted": 0,
//                 "orphan": 0, "failed": 0},
//      "results": [{
//        "case": 17, "id": "tiles/step-0090-bvh", "scene": "tiles", "name": "step-0090-bvh", "size": 20, "step": 90,
//        "kind": "overlap | render", "layers": "bodies,contacts",
//        "status": "equal | changed | size | state | missing | new | deleted | orphan | failed",
//        "message": "…", "state_changed": true,
//        "rule": {"tolerance": 0, "mask": [[x0, y0, x1, y1], …], "source": "default | tests/snapshots/….json",
//                 "reason": "…", "masked_pixels": 0, "tolerated_pixels": 0},
//        "expected": {"image": "expected/….png", "sidecar": "expected/….json", "width": 480, "height": 300} | null,
//        "actual": {"image": "actual/….png", …} | null,
//        "difference": "diff/….png" | null,
//        "changed_pixels": 12, "max_difference": 255, "box": [x0, y0, x1, y1] | null,
//        "structure": {"equal": false,
//          "bodies":   {"expected": 40, "actual": 40, "changed": 3, "added": 0, "removed": 0, "list": [
//            {"index": 7, "change": "changed | added | removed",
//             "expected": {"x": 1.25, "y": 0.5, "angle": 0.0, "awake": true} | null, "actual": {…} | null}]},
//          "nodes":    {… the same counts …, "list": [
//            {"index": 3, "change": …,
//             "expected": {"level": 2, "box": [lowerX, lowerY, upperX, upperY]} | null, "actual": … | null}]},
//          "contacts": {… the same counts …, "list": [
//            {"bodies": [3, 7], "fixtures": [3, 8], "change": …,
//             "expected": {"touching": true, "points": 2} | null, "actual": … | null}]}} | null,
//        "update": "scree snapshot update -g '^tiles/step-0090-bvh$'" | null,
//        "ms": {"simulate": 12.5, "render": 3.1, "compare": 0.4}}]}
//
// `renderer` is that of the actual pictures. The fields from `scene` to `layers` are absent in `scree diff`. `message`
// is one line for a reader, with the cure; `update` is the command that accepts the picture. `image` and `sidecar` are
// null where no file was left. `box` is half-open, in pixels. `cases` is how many the whole run has, `case` which of
// them it is: with --shard, `results` has only some. `state_changed`: the state hash or the structure differs; such a
// case leaves its files even if its pixels are equal.
// In a change, `expected` and `actual` may be null too when the sidecars keep only hashes. Bodies and nodes also have
// `block`: above 1, so many neighbours share a hash, and all of a block that changed count as changed. A `list` holds
// the first maxListed entries, the counts hold all. Lengths are m, angles rad, rounded as the sidecars store them.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "testbed/picture/image_compare.h"

namespace testbed {

enum class SnapshotStatus {
    equal,    ///< all pixels that count agree within the tolerance
    changed,  ///< same size, other pixels
    size,     ///< other width or height
    state,    ///< `--state exact`: no pixel counts as another, but the state hash or the structure is another
    missing,  ///< the catalogue has the picture, the references have not
    added,    ///< `scree diff`: only in the second folder; named "new"
    deleted,  ///< `scree diff`: only in the first folder; references: the sidecar is there, the picture is not
    orphan,   ///< a reference that the catalogue does not have
    failed,   ///< could not be made or read
};
inline constexpr std::array<std::string_view, 9> snapshotStatusNames = {
    "equal", "changed", "size", "state", "missing", "new", "deleted", "orphan", "failed"};

[[nodiscard]] inline std::string_view GetStatusName(SnapshotStatus status) {
    return snapshotStatusNames[static_cast<std::size_t>(status)];
}

/// One side of a comparison: files relative to the report's folder, empty where none was left.
struct SnapshotSide {
    std::string image, sidecar;
    int width = 0, height = 0;
};

struct SnapshotResult {
    std::string id;                         ///< <scene>/<name>, or the relative path in `scree diff`
    std::string scene, name, kind, layers;  ///< empty in `scree diff`
    int size = 0, step = 0;
    SnapshotStatus status = SnapshotStatus::equal;
    std::string message;
    bool isStateChanged = false;  ///< another state hash or structure
    CompareRule rule;
    PixelDifference pixels;
    std::optional<SnapshotSide> expected, actual;
    std::string difference;  ///< path of the difference picture, empty: none
    std::string structure;   ///< JSON text of the field, empty: null
    std::string update;      ///< the command that accepts the picture
    double simulateMs = 0, renderMs = 0, compareMs = 0;
    std::size_t number = 0;  ///< of the case in the whole run
};

/// Number of entries in the lists of `structure`.
inline constexpr std::size_t maxListed = 50;

/// What made `actual`.
struct SnapshotOrigin {
    std::string command, backend, renderer, version;
    std::size_t caseCount = 0;  ///< of the whole run
};

/// One entry of `results`; also the fields of a line of `--json`.
[[nodiscard]] nlohmann::ordered_json DescribeResult(const SnapshotResult& result);

/// The whole results.json.
[[nodiscard]] std::string WriteResults(const SnapshotOrigin& origin, std::span<const SnapshotResult> results);

/// What a results.json says.
struct WrittenResults {
    SnapshotOrigin origin;
    std::vector<SnapshotResult> results;
};

/// Throws FileError that names `file` for what WriteResults cannot have written, and for files outside of the report.
[[nodiscard]] WrittenResults ReadResults(const std::filesystem::path& file);

/// Whether all results are `equal`.
[[nodiscard]] bool IsClean(std::span<const SnapshotResult> results);

}  // namespace testbed
