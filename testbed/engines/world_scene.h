// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A world of an engine as a scene. Api is scree_capture::Api of the header that programs capture the engine with.

#pragma once

#include "testbed/capture/scree_capture_scene.h"
#include "testbed/input/scene_file.h"

namespace testbed {

template <typename Api>
scenes::Scene DescribeAsScene(typename Api::World& world, const scree_capture::Options& options = {}) {
    scree_capture::detail::JsonWriter text;
    scree_capture::detail::Numbers bodies, joints;
    (void)scree_capture::detail::WriteWorld<Api>(text, world, options, bodies, joints);
    return ReadScene(text.GetText(), "the world");
}

}  // namespace testbed
