// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What can be drawn of a snapshot: one table of layers, which the command line, the window, the legend and the drawing
// itself share. Its order is the order of drawing, lowest layer first.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace testbed {

enum class Layer : uint8_t {
    bodies,
    islands,
    partitions,
    bvh,
    fattened,
    swept,
    aabbs,
    joints,
    velocities,
    impulses,
    normals,
    contacts,
    labels,
};

inline constexpr std::size_t layerCount = 13;

struct LayerInfo {
    Layer layer;
    const char* name;     ///< on the command line
    const char* meaning;  ///< one line for --help and tooltips
};

inline constexpr std::array<LayerInfo, layerCount> layerTable{{
    {Layer::bodies, "bodies", "fixtures by state: awake, sleeping, static, kinematic, bullet, sensor"},
    {Layer::islands, "islands",
     "dynamic fixtures coloured by the island that contacts and joints make of their bodies"},
    {Layer::partitions, "partitions", "touching contacts by solver colour: those of one colour share no dynamic body"},
    {Layer::bvh, "bvh", "outlines of the tree nodes chosen by --nodes, coloured by level"},
    {Layer::fattened, "aabbs-fattened", "boxes that the broad phase keeps: Box2D's are fattened, ours tight"},
    {Layer::swept, "aabbs-swept", "boxes around a fixture before and after the step"},
    {Layer::aabbs, "aabbs", "tight boxes of fixtures"},
    {Layer::joints, "joints", "anchors, and lines from them to the bodies"},
    {Layer::velocities, "velocities", "arrows for linear, arcs for angular velocity"},
    {Layer::impulses, "impulses", "normal impulses of the last step, along the normal"},
    {Layer::normals, "normals", "contact normals, from fixture A to B"},
    {Layer::contacts, "contacts", "contact points"},
    {Layer::labels, "labels", "body indices"},
}};

/// A set of layers.
class Layers {
public:
    [[nodiscard]] bool Has(Layer layer) const { return (m_bits & Bit(layer)) != 0; }
    void Set(Layer layer, bool on = true) { m_bits = on ? m_bits | Bit(layer) : m_bits & ~Bit(layer); }
    [[nodiscard]] static Layers Bodies() {
        Layers layers;
        layers.Set(Layer::bodies);
        return layers;
    }
    friend bool operator==(const Layers&, const Layers&) = default;

private:
    [[nodiscard]] static constexpr uint32_t Bit(Layer layer) { return uint32_t{1} << static_cast<unsigned>(layer); }
    uint32_t m_bits = 0;
};

/// Names separated by commas, "bodies,contacts"; throws std::invalid_argument listing the names for an unknown one.
[[nodiscard]] Layers ParseLayers(std::string_view text);
/// The text that ParseLayers reads back, in the order of the table; empty for no layer.
[[nodiscard]] std::string GetLayerNames(const Layers& layers);
/// "bodies (meaning), …": a line per layer for --help.
[[nodiscard]] std::string DescribeLayers();

}  // namespace testbed
