#pragma once
/// Small scenes, sound in themselves, that the tests read and spoil.

namespace sunder::scene {

inline constexpr const char* static_scene = R"(name = "block"
analysis = "static"

[geometry]
outline = [[0, 0], [2, 0], [2, 3], [0, 3]]
boundaries = { base = [0], crest = [2], upstream = [3] }

[mesh]
size = 0.5
order = 2

[material]
youngs_modulus = 25e9
poisson_ratio = 0.2

[[support]]
boundary = "base"
fix = ["x", "y"]

[[load]]
boundary = "crest"
traction = [0.0, 1.0e6]
)";

inline constexpr const char* mesh_file_scene = R"(name = "from a file"
analysis = "static"
[mesh]
file = "dam.msh"
dual = true
[material]
youngs_modulus = 25e9
poisson_ratio = 0.2
[[support]]
boundary = "base"
fix = ["x", "y"]
)";

inline constexpr const char* dynamic_scene = R"(name = "Koyna"
analysis = "dynamic"

[geometry]
outline = [[0, 0], [70, 0], [19.25, 66.5], [14.8, 103], [0, 103]]
boundaries = { base = [0], downstream = [1, 2], crest = [3], upstream = [4] }

[mesh]
size = 2.4

[material]
youngs_modulus = 25e9
poisson_ratio = 0.2
density = 2450

[[crack]]
path = [[0, 60], [1, 60]]

[[crack]] # second
path = [[0, 40], [1, 40]]

[gravity]

[reservoir]
boundary = "upstream"
level = 96.5
model = "westergaard"

[foundation]
boundary = "base"
youngs_modulus = 25e9
poisson_ratio = 0.2
density = 0

[contact]
model = "exact"
initial_stiffness = 1e9
growth_factor = 2
friction_coefficient = 0.0

[crack_water]
model = "uniform"
relative_roughness = 0.25

[propagation]
fracture_toughness = 2e6
criterion = "max-hoop-stress"

[ground_motion]
horizontal = "koyna-1967/horizontal.csv"
horizontal_scale = -1

[dynamics]
time_step = 0.01
duration = 10
integrator = "generalised-alpha"
spectral_radius = 0.8
damping_modes = [1, 3]

[output]
fields_every = 10
)";

inline constexpr const char* crack_water_scene = R"(name = "45 m crack, closing"
analysis = "crack-water"
[crack_water]
[crack_line]
length = 45.0
segments = 450
aperture = [0.10, 0.05]
opening_rate = [-0.10, 0.0]
upstream_head = 50.0
tip = "closed"
march = { time_step = 1e-3, duration = 1.0, initially = "empty" }
quadrature = "midpoint"
)";

inline constexpr const char* response_scene = R"(name = "unbounded"
analysis = "response"
[reservoir]
depth = 100
[foundation]
youngs_modulus = 1
poisson_ratio = 0.25
density = 1
half_width = 1
shape = "disc"
[response]
frequencies = [0.5, 0.9]
times = [0.07]
face_elements = 10
face_order = 3
)";

}  // namespace sunder::scene
