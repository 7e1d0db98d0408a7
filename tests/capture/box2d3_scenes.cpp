// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Writes the worlds of Box2D 3's own benchmark as scene files, from its sources: tests/capture/box2d3_scenes builds it.
// The rain makes and destroys ragdolls while it runs. Its scene is a moment of it, with as many as it ever has.

#include <scree_capture_box2d3.h>

#include <cstdio>
#include <string>

extern "C" {
#include "benchmarks.h"
}

int main(int argc, char** argv) {
    if (argc != 2) return std::fprintf(stderr, "usage: box2d3_scenes FOLDER\n"), 2;
    const struct {
        const char* name;
        void (*create)(b2WorldId);
        float (*step)(b2WorldId, int) = nullptr;
        int steps = 0;  ///< that Box2D 3 takes before the moment
    } scenes[] = {{"compounds", &CreateCompounds},
                  {"joint-grid", &CreateJointGrid},
                  {"junkyard", &CreateJunkyard},
                  {"large-pyramid", &CreateLargePyramid},
                  {"many-pyramids", &CreateManyPyramids},
                  {"rain", &CreateRain, &StepRain, 400},
                  {"smash", &CreateSmash},
                  {"spinner", &CreateSpinner},
                  {"tumbler", &CreateTumbler},
                  {"washer", &CreateWasher}};
    for (const auto& scene : scenes) {
        b2WorldDef def = b2DefaultWorldDef();
        def.enableSleep = false;
        const b2WorldId world = b2CreateWorld(&def);
        scene.create(world);
        for (int step = 0; step < scene.steps; ++step) {
            scene.step(world, step);
            b2World_Step(world, 1.0f / 60.0f, 4);
        }
        const std::string path = std::string(argv[1]) + "/" + scene.name + ".scene.json";
        if (!scree_capture::WriteScene(world, path)) return std::fprintf(stderr, "cannot write %s\n", path.c_str()), 4;
        b2DestroyWorld(world);
    }
    return 0;
}
