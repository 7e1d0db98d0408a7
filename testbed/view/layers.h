// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What `scree render --layers` can draw of a snapshot.

#pragma once

#include <span>
#include <string_view>

namespace testbed {

struct Layers {
    bool bodies = false;
    bool contacts = false;  ///< a point per manifold point
    bool normals = false;   ///< from each manifold point, A to B
    bool impulses = false;  ///< along the normal, length by normal impulse
    bool joints = false;
    bool aabbs = false;    ///< tight boxes of fixtures
    bool islands = false;  ///< bodies coloured by connected group of touching or jointed dynamic bodies
    bool bvh = false;      ///< outlines of the selected nodes, coloured by level
    bool labels = false;   ///< body index

    [[nodiscard]] static Layers Bodies() {
        Layers layers;
        layers.bodies = true;
        return layers;
    }
};

/// A layer's name and its switch.
struct LayerName {
    std::string_view name;
    bool Layers::*isOn;
};

/// All layers, in the order in which users see them: the one list of the command line, the window and the messages.
[[nodiscard]] std::span<const LayerName> GetLayerNames();

/// Names separated by commas, "bodies,contacts"; throws std::invalid_argument listing the names for an unknown one.
[[nodiscard]] Layers ParseLayers(std::string_view text);

}  // namespace testbed
