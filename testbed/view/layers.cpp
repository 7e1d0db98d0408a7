// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Layer names in and out.

#include "testbed/view/layers.h"

#include <algorithm>
#include <stdexcept>

namespace testbed {

Layers ParseLayers(std::string_view text) {
    Layers layers;
    for (size_t start = 0; start <= text.size();) {
        const size_t comma = std::min(text.find(',', start), text.size());
        const std::string_view name = text.substr(start, comma - start);
        const auto found = std::find_if(layerTable.begin(), layerTable.end(),
                                        [name](const LayerInfo& info) { return name == info.name; });
        if (found == layerTable.end()) {
            std::string message = "unknown layer '" + std::string(name) + "': use";
            for (const LayerInfo& info : layerTable) message += std::string(" ") + info.name;
            throw std::invalid_argument(message + ", separated by commas");
        }
        layers.Set(found->layer);
        start = comma + 1;
    }
    return layers;
}

std::string GetLayerNames(const Layers& layers) {
    std::string names;
    for (const LayerInfo& info : layerTable) {
        if (layers.Has(info.layer)) names += (names.empty() ? "" : ",") + std::string(info.name);
    }
    return names;
}

std::string DescribeLayers() {
    std::string text;
    for (const LayerInfo& info : layerTable)
        text += std::string(text.empty() ? "" : "\n") + info.name + ": " + info.meaning;
    return text;
}

}  // namespace testbed
