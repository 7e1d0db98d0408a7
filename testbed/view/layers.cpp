// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Layer names.

#include "testbed/view/layers.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace testbed {

namespace {

constexpr std::array<LayerName, 9> layerNames{{{"bodies", &Layers::bodies},
                                               {"contacts", &Layers::contacts},
                                               {"normals", &Layers::normals},
                                               {"impulses", &Layers::impulses},
                                               {"joints", &Layers::joints},
                                               {"aabbs", &Layers::aabbs},
                                               {"islands", &Layers::islands},
                                               {"bvh", &Layers::bvh},
                                               {"labels", &Layers::labels}}};

}  // namespace

std::span<const LayerName> GetLayerNames() { return layerNames; }

Layers ParseLayers(std::string_view text) {
    Layers layers;
    for (size_t start = 0; start <= text.size();) {
        const size_t comma = std::min(text.find(',', start), text.size());
        const std::string_view name = text.substr(start, comma - start);
        bool isKnown = false;
        for (const auto& [knownName, member] : layerNames) {
            if (name != knownName) continue;
            layers.*member = true;
            isKnown = true;
        }
        if (!isKnown) {
            std::string message = "unknown layer '" + std::string(name) + "': use";
            for (const auto& [knownName, member] : layerNames) message += " " + std::string(knownName);
            throw std::invalid_argument(message + ", separated by commas");
        }
        start = comma + 1;
    }
    return layers;
}

}  // namespace testbed
