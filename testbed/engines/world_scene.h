// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A world of an engine as a scene, by the header that programs capture it with; included behind that header.

#pragma once

#include "testbed/capture/scree_capture_scene.h"
#include "testbed/input/scene_file.h"

namespace testbed {

template <typename World>
scenes::Scene DescribeAsScene(World& world, const scree_capture::Options& options = {}) {
    scree_capture::detail::JsonWriter text;
    scree_capture::detail::Numbers bodies, joints;
    (void)scree_capture::detail::WriteWorld<scree_capture::Api>(text, world, options, bodies, joints);
    return ReadScene(text.GetText(), "the world");
}

}  // namespace testbed
