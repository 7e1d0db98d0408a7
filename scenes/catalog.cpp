// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of scenes (suite_rows.h, classic_rows.h, joint_rows.h), look-up by exact and by nearest name, and checked
// building.

#include "scenes/catalog.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "scenes/classic_rows.h"
#include "scenes/joint_rows.h"
#include "scenes/suite_rows.h"

namespace scenes {

namespace {

constexpr auto catalog = [] {
    std::array<SceneInfo, std::size(suiteRows) + std::size(classicRows) + std::size(jointRows)> rows{};
    auto end = std::ranges::copy(suiteRows, rows.begin()).out;
    end = std::ranges::copy(classicRows, end).out;
    std::ranges::copy(jointRows, end);
    return rows;
}();

// Levenshtein's distance by the usual two-row recurrence.
std::size_t EditDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

const SceneInfo& FindOrThrow(std::string_view name) {
    if (const SceneInfo* info = Find(name)) return *info;
    std::string message = "unknown scene '" + std::string(name) + "'";
    std::string_view separator = "; nearest: ";
    for (std::string_view near : NearestNames(name)) {
        message.append(separator).append(near);
        separator = ", ";
    }
    throw std::invalid_argument(message);
}

void CheckSize(const SceneInfo& info, int size) {
    if (size >= info.minSize && size <= info.maxSize) return;
    std::string message = "scene '" + std::string(info.name) + "': size " + std::to_string(size) + " is not legal; ";
    if (info.hasSize) {
        message += "it must be " + std::to_string(info.minSize) + " to " + std::to_string(info.maxSize) + " (default " +
                   std::to_string(info.defaultSize) + ")";
    } else {
        message += "the scene has no size parameter, its size is always " + std::to_string(info.defaultSize);
    }
    throw std::out_of_range(message);
}

Scene BuildRow(const SceneInfo& info, int size) {
    Scene scene = info.build(size);
    scene.name = info.name;
    scene.size = size;
    if (scene.steps == 0) scene.steps = info.steps;
    if (scene.showStep == 0) scene.showStep = info.showStep;
    return scene;
}

}  // namespace

std::span<const SceneInfo> Catalog() { return catalog; }

const SceneInfo* Find(std::string_view name) {
    const auto row = std::ranges::find(catalog, name, &SceneInfo::name);
    return row == catalog.end() ? nullptr : row;
}

std::vector<std::string_view> NearestNames(std::string_view name, int count) {
    std::vector<std::pair<std::size_t, std::string_view>> ranked;
    for (const SceneInfo& info : catalog) ranked.emplace_back(EditDistance(name, info.name), info.name);
    std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, std::string_view>::first);
    std::vector<std::string_view> names;
    for (const auto& [distance, near] : ranked) {
        if (static_cast<int>(names.size()) == count) break;
        if (distance > std::max<std::size_t>(1, (std::max(name.size(), near.size()) + 1) / 2)) continue;
        names.push_back(near);
    }
    return names;
}

Scene Build(std::string_view name) {
    const SceneInfo& info = FindOrThrow(name);
    return BuildRow(info, info.defaultSize);
}

Scene Build(std::string_view name, int size) {
    const SceneInfo& info = FindOrThrow(name);
    CheckSize(info, size);
    return BuildRow(info, size);
}

}  // namespace scenes
