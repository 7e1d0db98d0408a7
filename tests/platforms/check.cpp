// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Are states the same on this machine as on all others? Runs every scene of the catalogue, nets of joints and a room of
// bounces by three kinds of step. Checks that other numbers of workers, a saved world and a recording lead to the same
// state. Holds a dozen longer runs, every scene and sequences of calls with any numbers to the golden hashes. Checks
// that a program's rounding mode does not matter. Prints a line per state, which tests/platforms/run compares with
// those of x86-64. Needs nothing but the engine: no test library, no exceptions.
//
//   scree_check          all of that; exit code 1 if anything differs
//   scree_check golden   golden hashes alone, with one worker and with three
//   scree_check quick    the scenes, a few steps each, and some of the calls
//   scree_check save     a world as an image to stdout
//   scree_check load     the hash of the world in the image on stdin, or why it was refused

#include <bit>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/compiler.h"
#include "base/simd.h"
#include "constraints/contact_block.h"
#include "scree/inspect.h"
#include "scree/scree.h"
#include "testbed/base/hash.h"
#include "tests/determinism/bounces.h"
#include "tests/determinism/calls.h"
#include "tests/determinism/golden_hashes.h"
#include "tests/determinism/nets.h"
#include "tests/determinism/round_shapes.h"
#include "tests/determinism/scene_hashes.h"
#include "tests/determinism/scene_run.h"
#include "tests/determinism/small_scenes.h"

#if defined(_WIN32)
#include <fcntl.h>
#include <io.h>
#endif

namespace {

using determinism::MakeDef;
using determinism::NameOf;
using determinism::SceneRun;
using determinism::StepKind;

int failures = 0;

void Fail(const std::string& what) {
    ++failures;
    std::printf("DIFFERS %s\n", what.c_str());
}

uint64_t ChecksumOf(std::span<const std::byte> bytes) {
    testbed::Fnv1a<uint64_t> sum;
    for (const std::byte byte : bytes) sum.Add(static_cast<uint64_t>(byte));
    return sum.Get();
}

void CheckGolden(const std::string& name, uint64_t hash, uint64_t golden) {
    std::printf("golden %s %016" PRIx64 "\n", name.c_str(), hash);
    if (hash != golden) Fail("golden " + name);
}

void CheckLongerRuns() {
    for (const determinism::GoldenHash& row : determinism::golden) {
        const scenes::Scene scene = scenes::Build(row.scene, row.size);
        for (const StepKind kind : {StepKind::sequential, StepKind::soft}) {
            scree::WorldDef def = MakeDef(scene);
            def.continuousPhysics = false;
            def.maxTranslation = scree::maxTranslation;
            def.maxRotation = scree::maxRotation;
            SceneRun run(scene, def, kind);
            run.Step(row.steps);
            CheckGolden(NameOf(row.scene, kind), run.GetBodyHash(), kind == StepKind::soft ? row.softHash : row.hash);
        }
    }
    for (const bool withTolerance : {false, true}) {
        CheckGolden(NameOf("round-shapes", withTolerance ? StepKind::tolerant : StepKind::sequential),
                    determinism::HashOfRoundShapes(withTolerance), determinism::goldenRound[withTolerance ? 1 : 0]);
    }
}

/// Of a small scene after sceneSteps; 0: there is none.
uint64_t FindSceneHash(const scenes::Scene& scene, StepKind kind) {
    for (const determinism::SceneHashes& row : determinism::sceneHashes) {
        if (scene.name == row.scene) return row.hashes[static_cast<int>(kind)];
    }
    return 0;
}

void CheckSceneHash(const scenes::Scene& scene, StepKind kind) {
    const std::string name = NameOf(scene.name.c_str(), kind);
    for (const int workers : {1, 3}) {
        SceneRun run(scene, MakeDef(scene, workers), kind);
        run.Step(determinism::sceneSteps);
        const uint64_t hash = run.GetHash();
        if (workers == 1) std::printf("state %s %016" PRIx64 "\n", name.c_str(), hash);
        if (hash != FindSceneHash(scene, kind)) Fail(name + ", " + std::to_string(workers) + " workers: golden hash");
    }
}

/// Half of the steps, an image, and the other half; all of it recorded.
void CheckScene(const scenes::Scene& scene, StepKind kind, int halfSteps) {
    const std::string name = NameOf(scene.name.c_str(), kind);
    scree::Recorder recorder;
    SceneRun run(scene, MakeDef(scene), kind);
    StartRecording(run.GetWorld(), recorder);
    run.Step(halfSteps);
    const std::vector<std::byte> image = SaveWorld(run.GetWorld());
    std::optional<SceneRun> restored;
    restored.emplace(run, image);
    run.Step(halfSteps);
    const uint64_t hash = run.GetHash();
    scree::StopRecording(run.GetWorld());
    std::printf("state %s %016" PRIx64 "\n", name.c_str(), hash);
    std::printf("image %s %016" PRIx64 "\n", name.c_str(), ChecksumOf(image));
    if (2 * halfSteps == determinism::sceneSteps && hash != FindSceneHash(scene, kind)) Fail(name + ": golden hash");

    if (restored->IsLoaded()) restored->Step(halfSteps);
    if (!restored->IsLoaded() || restored->GetHash() != hash) Fail(name + ": restored");
    testbed::Conveyor conveyor(scene);
    const scree::ReplayReport replay =
        scree::Replay(recorder.GetBytes(), [&](scree::World& world) { world.SetContactListener(&conveyor); });
    const bool isSame = replay.valid && replay.firstDifference == 0 && replay.steps == 2 * halfSteps;
    if (!isSame || scree::inspect::GetStateHash(*replay.world) != hash) Fail(name + ": replayed");
    for (const int workers : {2, 3, 8}) {
        SceneRun shared(scene, MakeDef(scene, workers), kind);
        shared.Step(2 * halfSteps);
        if (shared.GetHash() != hash) Fail(name + ": " + std::to_string(workers) + " workers");
    }
}

/// A few of them if it is to be quick.
void CheckCalls(bool isQuick) {
    fuzz::onBroken = [](const char* law) {
        std::printf("DIFFERS calls: %s\n", law);
        std::exit(1);
    };
    const size_t groups = isQuick ? 4 : std::size(determinism::goldenCalls);
    for (size_t group = 0; group < groups; ++group)
        CheckGolden("calls " + std::to_string(group), determinism::HashOfCalls(group), determinism::goldenCalls[group]);
}

/// Numbers near 0 are rounded to 0, and others downwards, as some programs want it for their threads.
[[maybe_unused]] void SpoilFloatMode(bool spoil) {
#if defined(SCREE_HAS_SSE2)
    _mm_setcsr(spoil ? 0xBFC0 : 0x1F80);
#elif defined(__aarch64__)
    const uint64_t mode = spoil ? 0x01800000 : 0;
    asm volatile("msr fpcr, %0" : : "r"(mode) : "memory");
#elif defined(__arm__)
    const uint32_t mode = spoil ? 0x01800000 : 0;
    asm volatile("vmsr fpscr, %0" : : "r"(mode) : "memory");
#endif
}

/// Pairs of welded boxes and single disks, many enough for several workers, that creep: their moves are denormal.
uint64_t HashOfCreeping(StepKind kind, int workers, bool spoil) {
    scree::WorldDef def;
    def.gravity = {1e-39f, -2e-39f};
    def.workerCount = workers;
    SpoilFloatMode(spoil);  // of threads that are made, too
    scree::World world(def);
    SpoilFloatMode(false);
    scree::PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    scree::CircleShape disk;
    disk.m_radius = 0.5f;
    scree::Body* before = nullptr;
    for (int i = 0; i < 600; ++i) {
        scree::BodyDef body;
        body.type = scree::dynamicBody;
        body.position = {i == 0 ? 0.0f : 1.5f * static_cast<float>(i % 30), 1.5f * static_cast<float>(i / 30)};
        body.linearVelocity = {1e-39f * static_cast<float>(i + 1), 0.3f + 0.01f * static_cast<float>(i % 7)};
        body.angularVelocity = 1e-39f * static_cast<float>(i);
        body.allowSleep = false;
        scree::Body* made = world.CreateBody(&body);
        i % 3 == 0 ? made->CreateFixture(&disk, 1.0f) : made->CreateFixture(&box, 1.0f);
        if (i % 5 == 1) {
            scree::WeldJointDef weld;
            weld.Initialize(before, made, before->GetPosition());
            world.CreateJoint(&weld);
        }
        before = made;
    }
    SpoilFloatMode(spoil);
    for (int i = 0; i < 20; ++i) {
        kind == StepKind::sequential ? world.Step(1.0f / 60.0f, 8, 3) : world.Step(1.0f / 60.0f, 4);
    }
    SpoilFloatMode(false);
    return scree::inspect::GetStateHash(world);
}

void CheckFloatModes() {
    for (const StepKind kind : {StepKind::sequential, StepKind::soft}) {
        const std::string name = determinism::kindNames[static_cast<int>(kind)];
        const uint64_t hash = HashOfCreeping(kind, 1, false);
        std::printf("state creeping %s %016" PRIx64 "\n", name.c_str(), hash);
        for (const int workers : {1, 3}) {
            if (HashOfCreeping(kind, workers, true) != hash) {
                Fail("creeping " + name + ", rounding of the program, " + std::to_string(workers) + " workers");
            }
        }
    }
}

int CheckAll(const std::string& what) {
    const bool isQuick = what == "quick", isGolden = what == "golden";
    const char* order = std::endian::native == std::endian::little ? "little" : "big";
#if defined(SCREE_HAS_THREADS)
    const char* threads = "threads";
#else
    const char* threads = "no threads";
#endif
    std::printf("target %s, kernels %s, %d bits, %s endian, %s\n", scree::simdName, scree::GetContactKernels().name,
                static_cast<int>(8 * sizeof(void*)), order, threads);
    if (!isQuick) CheckLongerRuns();
    CheckCalls(isQuick);
    const auto check = [&](const scenes::Scene& scene) {
        for (const StepKind kind : determinism::stepKinds) {
            isGolden ? CheckSceneHash(scene, kind) : CheckScene(scene, kind, isQuick ? 3 : determinism::sceneSteps / 2);
        }
    };
    for (const scenes::SceneInfo& info : scenes::Catalog()) check(determinism::BuildSmall(info));
    check(determinism::BuildNets());
    check(determinism::BuildBounces());
    if (!isQuick && !isGolden) CheckFloatModes();
    std::printf("failures %d\n", failures);
    return failures == 0 ? 0 : 1;
}

int Save() {
    const scenes::Scene scene = scenes::Build("ragdolls");
    SceneRun run(scene, MakeDef(scene), StepKind::soft);
    run.Step(60);
    const std::vector<std::byte> image = SaveWorld(run.GetWorld());
    std::fwrite(image.data(), 1, image.size(), stdout);
    return 0;
}

int Load() {
    std::vector<std::byte> image;
    std::byte block[4096];
    for (size_t count = 1; count > 0;) {
        count = std::fread(block, 1, sizeof block, stdin);
        image.insert(image.end(), block, block + count);
    }
    scree::SnapshotError error{};
    const std::unique_ptr<scree::World> world = scree::LoadWorld(image, &error);
    if (world == nullptr) {
        std::printf("refused: %s\n", scree::GetName(error));
        return 0;
    }
    for (int i = 0; i < 30; ++i) world->Step(1.0f / 60.0f, 4);
    std::printf("loaded %016" PRIx64 "\n", scree::inspect::GetStateHash(*world));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
#if defined(_WIN32)
    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(_fileno(stdout), _O_BINARY);
#endif
    const std::string what = argc > 1 ? argv[1] : "";
    return what == "save" ? Save() : what == "load" ? Load() : CheckAll(what);
}
