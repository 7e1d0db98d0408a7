// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Damaged recordings, with and without right checksums of their entries. Law: a replay ends, and its world can be saved
// and loaded.

#include <memory>
#include <vector>

#include "scree/scree.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/small_world.h"

namespace fuzz {
namespace {

std::vector<std::byte> MakeRecording() {
    using namespace scree;
    const std::unique_ptr<World> world = MakeSmallWorld();
    Recorder recorder;
    StartRecording(*world, recorder);
    for (int i = 0; i < 6; ++i) {
        BodyDef def;
        def.type = dynamicBody;
        def.position = {static_cast<float>(i), 5.0f};
        Body* body = world->CreateBody(&def);
        CircleShape circle;
        circle.m_radius = 0.3f;
        body->CreateFixture(&circle, 1.0f);
        body->ApplyLinearImpulseToCenter({0.1f, 0.2f}, true);
        i % 2 == 0 ? world->Step(1.0f / 60.0f, 4) : world->Step(1.0f / 60.0f, 8, 3);
        if (i == 3) world->DestroyBody(body);
    }
    StopRecording(*world);
    const std::span<const std::byte> bytes = recorder.GetBytes();
    return {bytes.begin(), bytes.end()};
}

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const std::vector<std::byte> whole = fuzz::MakeRecording();
    fuzz::Input input(data, size);
    std::vector<std::byte> bytes = whole;
    for (int i = 0; i < 6 && !input.IsEmpty(); ++i) {
        const size_t offset = input.Word();
        const size_t at = offset % bytes.size();
        switch (input.Choose(4)) {
            case 0:
                bytes.resize(at + 1);
                break;
            case 1:
                bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), std::byte{input.Byte()});
                break;
            default:
                bytes[bytes.size() - 1 - at] = std::byte{input.Byte()};
        }
    }
    const auto quiet = [](scree::World& world) { world.SetErrorHandler([](const scree::Error&, void*) {}, nullptr); };
    const scree::ReplayReport report = scree::Replay(bytes, quiet);
    if (report.world != nullptr) {
        fuzz::Demand(scree::LoadWorld(scree::SaveWorld(*report.world)) != nullptr, "a replayed world can be saved");
    }
    return 0;
}
