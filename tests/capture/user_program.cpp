// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every call of a capture header, as a user's program has them: compiled with each header, engine and standard.

#include CAPTURE_HEADER

void Record(scree_capture::Api::World& world, const scree_capture::Api::Body* player) {
    scree_capture::Options options;
    options.contacts = options.tree = options.stages = true;
    options.velocityIterations = 10;
    scree_capture::Track track(world, "session.track", options);
    track.KeepLast(10.0);
    track.Name(player, "player");
    track.Mark("level 1");
    track.Step(1.0f / 60.0f);
    track.Refresh();
    track.Flush();
    if (!track.Save() || !track.Save("crash.track")) std::puts(track.GetError().c_str());
    if (track.GetSkippedSteps() > 0) std::puts("the disk is too slow");
    track.Close();
    if (!scree_capture::WriteScene(world, "level.scene.json")) std::puts("level.scene.json cannot be written");
}

// What the front page shows.
void RecordAll(scree_capture::Api::World& world, int steps, float dt) {
    scree_capture::Track track(world, "session.track");  // once, when the level is loaded
    for (int step = 0; step < steps; ++step) {
        track.Step(dt);  // after every step of the world
    }
}
