// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the window shows and what its user may change. It has the scene, one run per pane with the same input to all,
// one camera, layers, tree nodes, and what the pointer found. Data and the actions on it; drawing is in panels.h and
// scene_view.h.

#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "testbed/engines/engine_run.h"
#include "testbed/engines/panes.h"
#include "testbed/engines/run_history.h"
#include "testbed/moments/moment.h"
#include "testbed/options/condition_options.h"
#include "testbed/options/scene_input.h"
#include "testbed/picture/image.h"
#include "testbed/picture/palette.h"
#include "testbed/picture/theme.h"
#include "testbed/view/camera.h"
#include "testbed/view/layers.h"
#include "testbed/view/nodes.h"
#include "testbed/view/tree_query.h"

namespace testbed {

inline constexpr size_t historyLength = 240;  ///< steps that the timing plots show

/// A pane that may be shown.
struct PaneChoice {
    Pane pane;  ///< as it begins with every scene
    bool isOn = true;
    RunSpec now;  ///< with what the user changed since
};

/// One pane that is shown: its run, what it looks like now, its times, and where on the picture it is.
struct EnginePane {
    std::string name;
    size_t choice = 0;  ///< index into Viewer::choices
    std::unique_ptr<RunHistory> run;
    Snapshot snapshot;
    std::vector<StepTimes> history;  ///< of the last steps, the newest last
    PixelBox area{};                 ///< of the window's picture
    std::unique_ptr<Watch> watch{};  ///< break conditions, if there are any
    int watched = 0;                 ///< the last step that they saw

    int hoveredNode = -1;             ///< under the pointer
    std::optional<QueryTrace> trace;  ///< of the traced query, on the tree as it is now
};

/// How panes lie; `automatic` takes what shows the scene larger.
enum class PaneLayout { automatic, beside, above };

struct ViewerLook {
    Layers layers;
    bool overlap = true;  ///< counts of tree nodes behind the bodies
    NodeSelection nodes;
    Style style = Style::alpha;
    float opacity = static_cast<float>(usualOpacity);
    int scaleMax = 40;    ///< count at the end of the colour scale, for all styles but alpha
    bool smooth = false;  ///< four samples a pixel
    Theme theme = Theme::dark;
    PaneLayout layout = PaneLayout::automatic;
    bool panels = true;
};

/// A body that follows the pointer, in every pane.
struct Drag {
    int body = -1;
    Vec2 localPoint{}, target{};
};

/// What a press inside a pane has begun.
struct Press {
    size_t pane = 0;
    float x = 0, y = 0;  ///< where, pixels of the picture
    int button = 0;
    bool hasMoved = false;  ///< too far to be a click
};

/// Something that a break condition found.
struct BreakMoment {
    size_t pane = 0;
    Moment moment{};
};

/// These panes turned on, and the engines that none of them runs turned off.
[[nodiscard]] std::vector<PaneChoice> MakeChoices(const std::vector<Pane>& panes);

struct Viewer {
    SceneInput scene;
    std::vector<PaneChoice> choices = MakeChoices(ParsePanes("scree,box2d", {}, comparisonBase));
    std::vector<EnginePane> panes;
    std::optional<size_t> edited;  ///< the choice whose settings are changed; none: all
    Iterations iterations;         ///< last seen, for when sequential impulses are turned on again

    bool isPaused = false;
    bool playsBackward = false;              ///< where it is not paused
    size_t memoryLimit = size_t{256} << 20;  ///< bytes that all panes together keep to go back
    SessionArguments session;                ///< for conditions that run another engine
    ConditionArguments conditions;           ///< that stop it
    std::vector<BreakMoment> moments;        ///< that were found
    bool mustStop = false;                   ///< one of them just now
    std::vector<std::string> names;          ///< of bodies by index, as their file has them
    std::string whenText, pickText;          ///< that are being typed
    bool follows = false;                    ///< the picked body stays in the middle
    bool showsInspector = false;             ///< instead of layers, nodes and colours
    bool mustTurnPage = false;               ///< of these two, to the one that is asked for
    size_t inspectedPane = 0;
    int bulletCount = 0;
    ViewerLook look;
    std::optional<CameraRequest> camera;  ///< instead of the next fit
    double cameraX = 0, cameraY = 0, pixelsPerMetre = 10;
    bool isBeside = true;  ///< how the panes lie
    bool mustFit = true;   ///< choose layout and camera anew when the panes are arranged

    std::optional<Press> press;
    std::optional<Drag> drag;
    std::optional<Vec2> query;  ///< centre of the traced query
    float querySize = 0;        ///< its edges, m
    int pickedBody = -1;        ///< index in the scene of the body that was last pressed

    std::string search;     ///< over the scenes' names
    std::string message;    ///< of the last thing that happened
    bool showTimes = true;  ///< false: all times count as 0, so that pictures of a run repeat
    double framesPerSecond = 0;
    bool wantsScreenshot = false;
};

/// Builds the scene and its runs. Throws std::out_of_range for an illegal size, std::invalid_argument as the runs do;
/// the viewer keeps what it had then.
void LoadScene(Viewer& viewer, const SceneInput& scene);
/// The same scene from its beginning, with the panes and the settings that are chosen now.
void Restart(Viewer& viewer);
/// The neighbour in the catalogue's order, at its default size; the ends meet, and a file lies between them.
void LoadNeighbour(Viewer& viewer, int offset);
/// Turns a pane on or off and restarts; the last one stays on.
void TogglePane(Viewer& viewer, size_t choice);
/// Chooses the algorithm of the edited panes, as far as their engines have a choice, and restarts.
void SetBroadPhase(Viewer& viewer, std::string_view name);
/// The spec that the panel shows: of the edited pane if it is shown, else of the first one.
[[nodiscard]] const RunSpec& GetShownSpec(const Viewer& viewer);
/// Changes the specs of the edited panes, all or none. Throws std::invalid_argument for illegal values.
void ChangeSettings(Viewer& viewer, const std::function<void(RunSpec&)>& change);
/// Of the edited panes that use sequential impulses.
void SetIterations(Viewer& viewer, Iterations iterations);
/// Of the edited panes whose engine has soft steps; 0: sequential impulses.
void SetSubsteps(Viewer& viewer, int substeps);

/// One step in every pane, and what they look like after it. Break conditions look at it and may stop the window.
void StepAll(Viewer& viewer);
/// What a pane looks like now.
void Capture(Viewer& viewer, EnginePane& pane);

// In time (viewer_time.cpp).
/// Place of a body in a snapshot by its index in the scene; −1: it is not there.
[[nodiscard]] int FindBody(const Snapshot& snapshot, int index);
/// "hero (1)", or "body 1" without a name.
[[nodiscard]] std::string NameOfBody(const Viewer& viewer, int body);
/// "scree: step 25: when: hero (1): body("hero").y < 0 holds"
[[nodiscard]] std::string DescribeMoment(const Viewer& viewer, const BreakMoment& one);
/// By name or index. What is none becomes the message.
void PickBody(Viewer& viewer, std::string_view text);
[[nodiscard]] int GetStep(const Viewer& viewer);
[[nodiscard]] int GetFirstStep(const Viewer& viewer);
[[nodiscard]] int GetLastStep(const Viewer& viewer);
/// All panes to a step between these, without pausing; a drag ends.
void ComeToStep(Viewer& viewer, int step);
/// The same, and pauses.
void GoToStep(Viewer& viewer, int step);
void PlayBackward(Viewer& viewer, bool isOn);
/// The next step of what is played, if it is not paused.
void Advance(Viewer& viewer);
/// Pauses at a moment that was found since the last call, where it began.
void StopIfFound(Viewer& viewer);
/// Shows the break conditions of a pane its step, if they have not seen it.
void ShowToWatch(Viewer& viewer, size_t pane);
/// Break conditions of a pane begin anew from its step on. Throws UsageError for what cannot be meant.
void RenewWatch(Viewer& viewer, size_t pane);
/// Stops when an expression holds, and at nothing else; empty: at nothing. Throws UsageError.
void StopWhen(Viewer& viewer, const std::string& text);
/// Something that a user does in one pane. In the past it forgets the future, and conditions look anew.
void DoInPane(Viewer& viewer, size_t pane, bool renews, const std::function<void(RunHistory&)>& action);
/// Of the picked body, in every pane whose engine can. Throws std::invalid_argument if none does.
void EditBody(Viewer& viewer, const BodyEdit& edit);
/// <scene>-<step>.scene.json in the current folder. Throws FileError.
void SaveScene(Viewer& viewer);
/// <scene>-<pane>.track for each pane: all steps with all that was done.
void SaveTracks(Viewer& viewer);

void BeginDrag(Viewer& viewer, const EnginePane& pane, int body, Vec2 point);
void MoveDrag(Viewer& viewer, Vec2 target);
void EndDrag(Viewer& viewer);
void ShootBullet(Viewer& viewer, Vec2 from, Vec2 velocity);

/// The camera of a pane.
[[nodiscard]] Camera GetCamera(const Viewer& viewer, const EnginePane& pane);
[[nodiscard]] Vec2 ToWorldPoint(const Camera& camera, double pixelX, double pixelY);
/// Zooms so that the world point at the pixel (of the pane) stays where it is.
void ZoomAt(Viewer& viewer, const EnginePane& pane, double pixelX, double pixelY, double factor);
/// Divides the picture's area among the panes, fits the camera when that is asked for.
void ArrangePanes(Viewer& viewer, const PixelBox& area);

/// Height of the highest tree shown.
[[nodiscard]] int GetTreeHeight(const Viewer& viewer);

}  // namespace testbed
