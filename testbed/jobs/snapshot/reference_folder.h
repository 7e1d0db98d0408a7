// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The folder of reference pictures: <scene>/<name>.png with a sidecar <scene>/<name>.json beside it. The sidecar may
// hold a rule by hand, which rewriting keeps:
//
//     "compare": {"tolerance": 2, "mask": [[x0, y0, x1, y1]], "reason": "why"}

#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "testbed/base/new_file.h"
#include "testbed/jobs/snapshot/result.h"
#include "testbed/picture/image.h"

namespace testbed {

/// What lies in the folder under one id; the picture and the sidecar may each be absent.
struct Reference {
    bool hasImage = false, hasSidecar = false;
    Image image;
    nlohmann::ordered_json sidecar;  ///< null without one
    CompareRule rule;
};

/// Throws FileError for a file that cannot be read, is no PNG picture, or holds no JSON object or a bad rule.
[[nodiscard]] Reference ReadReference(const std::filesystem::path& folder, const std::string& id);

/// Tolerance, mask and reason of a sidecar; the default rule for one without. `source` names the file in the rule and
/// in messages. Throws FileError.
[[nodiscard]] CompareRule ParseRule(const nlohmann::ordered_json& sidecar, const std::string& source);

/// Changes of the folder that are made together: until Finish, references are what they were.
class ReferenceChange {
public:
    explicit ReferenceChange(std::filesystem::path folder) : m_folder(std::move(folder)) {}

    /// Picture and sidecar, keeping the rule of the old sidecar. Writes them under temporary names. Throws FileError.
    void Write(const std::string& id, const Image& image, nlohmann::ordered_json sidecar,
               const nlohmann::ordered_json& oldSidecar);
    /// Picture and sidecar, and the folder of the scene when it is empty then.
    void Remove(const std::string& id) { m_removed.push_back(id); }
    /// Gives the files their names and removes what is to go. Throws FileError.
    void Finish();

private:
    std::filesystem::path m_folder;
    std::vector<NewFile> m_files;
    std::vector<std::string> m_removed;
};

/// Ids of all pictures and sidecars below the folder's first level; empty when the folder does not exist.
[[nodiscard]] std::set<std::string> ListReferences(const std::filesystem::path& folder);

/// A sidecar as it is written: one value a line.
[[nodiscard]] std::string FormatSidecar(const nlohmann::ordered_json& sidecar);

}  // namespace testbed
