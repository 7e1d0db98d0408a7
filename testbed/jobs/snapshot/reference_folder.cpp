// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The folder of reference pictures.

#include "testbed/jobs/snapshot/reference_folder.h"

#include <fmt/format.h>

#include <system_error>

#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/json_print.h"
#include "testbed/base/output.h"
#include "testbed/picture/png.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

fs::path PathOf(const fs::path& folder, const std::string& id, const char* extension) {
    return folder / (id + extension);
}

[[noreturn]] void RefuseRule(const std::string& source) {
    throw FileError(fmt::format(R"({}: "compare" is {{"tolerance": 0 … 255, "mask": [[x0, y0, x1, y1], …], "reason": )"
                                R"("…"}}, and a rule other than the default needs its reason)",
                                source));
}

PixelArea ParseArea(const Json& json, const std::string& source) {
    if (!json.is_array() || json.size() != 4) RefuseRule(source);
    for (const Json& number : json) {
        if (!number.is_number_integer()) RefuseRule(source);
    }
    const PixelArea area{json[0], json[1], json[2], json[3]};
    if (area.x0 < 0 || area.y0 < 0 || area.x1 <= area.x0 || area.y1 <= area.y0) RefuseRule(source);
    return area;
}

void RemoveFile(const fs::path& path) {
    std::error_code error;
    fs::remove(path, error);
    if (error) throw FileError(fmt::format("cannot remove {}: {}", path.string(), error.message()));
}

}  // namespace

CompareRule ParseRule(const Json& sidecar, const std::string& source) {
    CompareRule rule;
    if (!sidecar.is_object() || !sidecar.contains("compare")) return rule;
    const Json& compare = sidecar["compare"];
    if (!compare.is_object()) RefuseRule(source);
    for (const auto& [key, value] : compare.items()) {
        if (key == "tolerance" && value.is_number_unsigned() && value <= 255) {
            rule.tolerance = value.get<int>();
        } else if (key == "mask" && value.is_array()) {
            for (const Json& area : value) rule.mask.push_back(ParseArea(area, source));
        } else if (key == "reason" && value.is_string()) {
            rule.reason = value.get<std::string>();
        } else {
            RefuseRule(source);
        }
    }
    if (rule.reason.empty()) RefuseRule(source);
    rule.source = source;
    return rule;
}

Reference ReadReference(const fs::path& folder, const std::string& id) {
    const fs::path image = PathOf(folder, id, ".png"), sidecar = PathOf(folder, id, ".json");
    Reference reference;
    reference.hasImage = fs::exists(image);
    reference.hasSidecar = fs::exists(sidecar);
    if (reference.hasImage) reference.image = ReadPng(image);
    if (reference.hasSidecar) {
        reference.sidecar = ReadJsonObject(sidecar);
        reference.rule = ParseRule(reference.sidecar, id + ".json");
    }
    return reference;
}

std::string FormatSidecar(const Json& sidecar) {
    std::string text;
    for (const auto& [key, value] : sidecar.items()) {
        text += fmt::format("{}{}: {}", text.empty() ? "{\n" : ",\n", PrintJson(Json(key)), PrintJson(value));
    }
    return text + "\n}\n";
}

void ReferenceChange::Write(const std::string& id, const Image& image, Json sidecar, const Json& oldSidecar) {
    if (oldSidecar.is_object() && oldSidecar.contains("compare")) sidecar["compare"] = oldSidecar["compare"];
    const OutputFolder output(m_folder);
    const auto write = [&](const char* extension, std::string_view content) {
        m_files.push_back(output.Begin(id + extension));
        m_files.back().Write(content);
    };
    const std::vector<unsigned char> png = EncodePng(image);
    write(".png", std::string_view(reinterpret_cast<const char*>(png.data()), png.size()));
    write(".json", FormatSidecar(sidecar));
}

void ReferenceChange::Finish() {
    for (NewFile& file : m_files) file.Finish();
    m_files.clear();
    for (const std::string& id : m_removed) {
        RemoveFile(PathOf(m_folder, id, ".png"));
        RemoveFile(PathOf(m_folder, id, ".json"));
        const fs::path parent = PathOf(m_folder, id, ".png").parent_path();
        if (fs::is_empty(parent)) RemoveFile(parent);
    }
    m_removed.clear();
}

std::set<std::string> ListReferences(const fs::path& folder) {
    std::set<std::string> ids;
    if (!fs::exists(folder)) return ids;
    for (const fs::directory_entry& scene : fs::directory_iterator(folder)) {
        if (!scene.is_directory()) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(scene.path())) {
            const fs::path extension = entry.path().extension();
            if (!entry.is_regular_file() || (extension != ".png" && extension != ".json")) continue;
            ids.insert(fs::relative(entry.path(), folder).replace_extension().generic_string());
        }
    }
    return ids;
}

}  // namespace testbed
