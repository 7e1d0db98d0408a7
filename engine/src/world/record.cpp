// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Calls → bytes. A recording is its format's name, the size and bytes of a snapshot, then one entry per call: number,
// size, checksum, arguments.

#include "world/record.h"

#include "scree/snapshot.h"
#include "world/guard.h"

namespace scree {

namespace {

template <typename Object>
int IndexOf(const Object* object) {
    return object == nullptr ? -1 : object->GetIndex();
}

}  // namespace

void Recorder::Append(uint32_t call, std::span<const std::byte> arguments) {
    ImageWriter out;
    out(call);
    out(static_cast<uint32_t>(arguments.size()));
    out(EntryChecksum(call, arguments));
    out.Append(arguments);
    m_bytes.insert(m_bytes.end(), out.Bytes().begin(), out.Bytes().end());
}

void Recording::NoteHash(uint64_t hash) const {
    ImageWriter out;
    out(hash);
    m_recorder->Append(hashRecord, out.Bytes());
}

void Recording::Write(ImageWriter& out, const Shape& shape) {
    out(shape.GetType());
    if (shape.GetType() == Shape::e_chain) return out(static_cast<const ChainShape&>(shape));
    WithShapeType(shape.GetType(), [&]<typename T>(std::type_identity<T>) { out(static_cast<const T&>(shape)); });
}

void Recording::Write(ImageWriter& out, const FixtureDef& def) {
    out(def);
    Write(out, *def.shape);
}

void Recording::Write(ImageWriter& out, const JointDef& def) {
    const auto& [type, userData, bodyA, bodyB, collideConnected, forceThreshold, torqueThreshold, breaks] = def;
    out(type, userData, collideConnected, forceThreshold, torqueThreshold, breaks, IndexOf(bodyA), IndexOf(bodyB));
    const auto write = [&]<typename Store>(std::type_identity<Store>) {
        if (Store::RowType::type != def.type) return;
        Store::RowType::DefinitionFields(static_cast<const typename Store::RowType::Definition&>(def), out);
    };
    [&]<typename... Stores>(std::type_identity<std::tuple<Stores...>>) {
        (write(std::type_identity<Stores>{}), ...);
    }(std::type_identity<decltype(JointTable::stores)>{});
    if (def.type != e_gearJoint) return;
    out(IndexOf(static_cast<const GearJointDef&>(def).joint1));
    out(IndexOf(static_cast<const GearJointDef&>(def).joint2));
}

ErrorCode StartRecording(World& world, Recorder& recorder) {
    WorldState& s = world.GetState();
    if (s.IsLocked())
        return s.Refuse(ErrorCode::locked, "StartRecording", "world",
                        "start a recording outside of Step and callbacks");
    const std::vector<std::byte> image = SaveWorld(world);
    ImageWriter out;
    out(recordingMagic);
    out(static_cast<uint64_t>(image.size()));
    out.Append(image);
    recorder = Recorder();
    recorder.m_bytes = std::move(out.Bytes());
    s.recorder = &recorder;
    return ErrorCode::ok;
}

void StopRecording(World& world) { world.GetState().recorder = nullptr; }

}  // namespace scree
