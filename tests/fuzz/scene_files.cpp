// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Damaged scene files. Laws: reading ends with a scene or a FileError. A scene that was read is written and read to the
// same text, and the engine makes a world of it that can be stepped. The input is a list of edits to a sound file.

#include <string>
#include <vector>

#include "scenes/catalog.h"
#include "scree/scree.h"
#include "testbed/base/errors.h"
#include "testbed/engines/scree_joint.h"
#include "testbed/engines/scree_scene.h"
#include "testbed/engines/scree_shape.h"
#include "testbed/input/scene_file.h"
#include "tests/fuzz/input.h"

namespace fuzz {
namespace {

std::vector<std::string> SoundFiles() {
    std::vector<std::string> texts;
    for (const char* name : {"car", "slider-crank", "gears", "convex-shapes", "joint-wheel", "joint-distance"}) {
        texts.push_back(testbed::WriteScene(scenes::Build(name)));
    }
    return texts;
}

void Damage(Input& input, std::string& text) {
    constexpr const char* hostile[] = {"1e39",     "-1e-46", "0",      "-1",         "null", "true",   "\"\"",
                                       "[]",       "{}",     "1e308",  "2147483648", "-0.0", "1e18",   "[[1,2]]",
                                       "\"text\"", "0.005",  "100000", "1e-30",      "255",  "[0,0,0]"};
    constexpr int mostEdits = 6;
    for (int i = 0; i < mostEdits && !input.IsEmpty() && !text.empty(); ++i) {
        const size_t at = input.Word() % text.size();
        switch (input.Choose(6)) {
            case 0:
                text[at] = static_cast<char>(input.Byte());
                break;
            case 1:
                text.erase(at, 1 + input.Byte());
                break;
            case 2:
                text.insert(at, text.substr(at / 2, 1 + input.Byte()));
                break;
            default: {
                // The next number becomes something else.
                const size_t begin = text.find_first_of("-0123456789", at);
                if (begin == std::string::npos) break;
                const size_t end = std::min(text.find_first_not_of("-+.eE0123456789", begin), text.size());
                text.replace(begin, end - begin, hostile[input.Choose(static_cast<int>(std::size(hostile)))]);
            }
        }
    }
}

void Run(const scenes::Scene& scene) {
    constexpr int mostBodies = 200;
    scree::WorldDef def;
    def.gravity = testbed::ToScree(scene.gravity);
    scree::World world(def);
    world.SetErrorHandler(
        [](const scree::Error& error, void*) {
            std::fprintf(stderr, "%s: %s; %s\n", error.function, error.field, error.cure);
            Demand(false, "the engine refuses nothing of a scene that was read");
        },
        nullptr);
    testbed::ScreeBodies bodies;
    for (int i = 0; i < scene.InitialBodyCount() && i < mostBodies; ++i) {
        bodies.push_back(testbed::CreateScreeBody(world, scene, i));
    }
    std::vector<scree::Joint*> joints;
    if (static_cast<int>(bodies.size()) == scene.InitialBodyCount()) {
        for (const scenes::Joint& joint : scene.joints) {
            joints.push_back(testbed::CreateScreeJoint(world, joint, bodies, joints));
        }
    }
    world.Step(1.0f / 60.0f, 4);
    world.Step(1.0f / 60.0f, 8, 3);
}

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const std::vector<std::string> sound = fuzz::SoundFiles();
    fuzz::Input input(data, size);
    std::string text = sound[static_cast<size_t>(input.Choose(static_cast<int>(sound.size())))];
    fuzz::Damage(input, text);
    scenes::Scene scene;
    try {
        scene = testbed::ReadScene(text, "damaged.scene.json");
    } catch (const testbed::FileError&) {
        return 0;
    }
    const std::string written = testbed::WriteScene(scene);
    fuzz::Demand(testbed::WriteScene(testbed::ReadScene(written, "damaged.scene.json")) == written,
                 "a scene is read as it was written");
    fuzz::Run(scene);
    return 0;
}
