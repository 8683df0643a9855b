#include "solver/simulation/attached_foundation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <filesystem>
#include <fstream>

#include "solver/mesh/ground_block.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/simulation/response_cache.hpp"

namespace sunder::simulation {
namespace {

/// A block of rock below the surface and nothing on it; G = ρ = c_s = 1, width 3, depth 1.
Body bare_block(double size, int order) {
  Body body;
  body.polygons = mesh::block_below_strip(1.0, {.width = 0.5, .depth = 1.0, .size = size}, size, size);
  body.nodes = mesh::place_nodes(body.polygons, [order](int, int) { return order; });
  body.materials = {{.youngs_modulus = 2.5, .poisson_ratio = 0.25, .density = 1.0}};
  body.rock = 0;
  return body;
}

/// A pulse of 6 time units, a = d²/dt² of (1 - cos(2πt/6))³: at rest before and after, its wave is six blocks long.
SurfaceMotion pulse(double dt, bool vertical) {
  SurfaceMotion motion{.step = dt};
  std::vector<double>& a = vertical ? motion.vertical : motion.horizontal;
  const double w = 2.0 * M_PI / 6.0;
  for (int i = 0; i * dt <= 6.0 + 1e-12; ++i) {
    const double c = std::cos(w * i * dt), s = std::sin(w * i * dt);
    a.push_back(w * w * (3.0 * (1 - c) * (1 - c) * c + 6.0 * (1 - c) * s * s));
  }
  return motion;
}

struct Motion {
  double largest = 0.0;  ///< |w| on the free surface, over the largest ground displacement 8
};

/// Newmark's average acceleration on the whole block.
Motion shake(const Body& body, const SurfaceMotion& motion, double dt, int steps,
             const std::filesystem::path& cache = {}) {
  numerics::ThreadPool pool(1);
  Ledger ledger;
  const sbfem::Formation formation = sbfem::form(body.nodes, body.materials, {.with_mass = true});
  const auto dense = [](const Eigen::SparseMatrix<double>& lower) {
    const Eigen::MatrixXd matrix(lower);
    return Eigen::MatrixXd(matrix.selfadjointView<Eigen::Lower>());
  };
  const Eigen::MatrixXd K = dense(sbfem::assemble_stiffness(body.nodes, formation));
  const Eigen::MatrixXd M = dense(sbfem::assemble_mass(body.nodes, formation));
  AttachedFoundation rock = attach_foundation(body, motion, {.time_step = dt, .steps = steps}, cache, pool, ledger);
  const std::vector<int>& dofs = rock.medium->dofs;
  convolution::Convolution& convolution = *rock.medium->convolution;
  Eigen::MatrixXd effective = M + 0.25 * dt * dt * K;
  effective(dofs, dofs) += convolution.instantaneous_mass();
  const Eigen::PartialPivLU<Eigen::MatrixXd> factor(effective);
  Eigen::VectorXd w = Eigen::VectorXd::Zero(body.dofs()), v = w, a = w, history(std::ssize(dofs));
  Motion result;
  for (int n = 0; n <= steps; ++n) {
    const Eigen::VectorXd w_trial = n == 0 ? w : Eigen::VectorXd(w + dt * v + 0.25 * dt * dt * a);
    const Eigen::VectorXd v_trial = n == 0 ? v : Eigen::VectorXd(v + 0.5 * dt * a);
    Eigen::VectorXd force = -(K * w_trial);
    for (int c = 0; c < 2; ++c) {
      Eigen::VectorXd unit = Eigen::VectorXd::Zero(body.dofs());
      for (int i = c; i < body.dofs(); i += 2) unit[i] = rock.wave.surface(c, n);
      force -= M * unit;
    }
    convolution.history_force(history);
    force(dofs) += rock.wave.load.col(n) - history;
    const Eigen::VectorXd a_new = factor.solve(force);
    convolution.append(a_new(dofs));
    w = w_trial + 0.25 * dt * dt * a_new;
    v = v_trial + 0.5 * dt * a_new;
    a = a_new;
    for (int node = 0; node < body.nodes.node_count(); ++node) {
      if (body.nodes.coordinates()(1, node) > -1e-9)
        result.largest = std::max(result.largest, w.segment<2>(2 * node).norm() / 8.0);
    }
  }
  return result;
}

/// Without a dam the wave must pass: the whole surface moves with the record, w = 0, whatever the block.
TEST(AttachedFoundation, LetsAWavePassABlockWithoutADam) {
  for (const bool vertical : {false, true}) {
    double last = 1.0;
    for (const double size : {0.5, 0.25}) {
      const double dt = 0.2 * size;
      const Motion motion = shake(bare_block(size, 1), pulse(dt, vertical), dt, static_cast<int>(10.0 / dt));
      EXPECT_LT(motion.largest, 0.35 * last) << "second order: a quarter";
      // linear elements carry a wave of ω = 2π/6 with a relative error of (ωh/c)²/12
      EXPECT_LT(motion.largest, std::pow(2.0 * M_PI / 6.0 * size, 2) / 12.0);
      last = motion.largest;
    }
  }
}

std::filesystem::path fresh_folder(const char* name) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / name;
  std::filesystem::remove_all(folder);
  return folder;
}

TEST(ResponseCache, ReturnsTheSameBitsAndKnowsItsOwnFiles) {
  const std::filesystem::path folder = fresh_folder("sunder-cache-bits");
  CacheKey key("test"), other("test");
  key.add(0.1);
  other.add(0.2);
  EXPECT_FALSE(read_weights(folder, key).weights);
  convolution::WeightSequence weights{2, false, Eigen::MatrixXd::Random(4, 5)};
  weights.values.row(2) = weights.values.row(1);
  EXPECT_EQ(write_weights(folder, key, weights), "");
  const CachedWeights back = read_weights(folder, key);
  ASSERT_TRUE(back.weights);
  EXPECT_EQ(back.weights->values, weights.values);
  EXPECT_NE(key.file_name(), other.file_name());
  // a file that another key's hash would lead to
  std::filesystem::copy_file(folder / key.file_name(), folder / other.file_name());
  EXPECT_NE(read_weights(folder, other).fault.find("another domain"), std::string::npos);
  EXPECT_FALSE(read_weights(folder, other).weights);
}

TEST(ResponseCache, NoticesEveryDamagedByteAndEveryLostOne) {
  const std::filesystem::path folder = fresh_folder("sunder-cache-damage");
  CacheKey key("test");
  convolution::WeightSequence weights{1, false, Eigen::MatrixXd::Random(1, 3)};
  ASSERT_EQ(write_weights(folder, key, weights), "");
  const std::filesystem::path file = folder / key.file_name();
  std::ifstream in(file, std::ios::binary);
  const std::string sound{std::istreambuf_iterator<char>(in), {}};
  const auto with = [&](const std::string& bytes) {
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return read_weights(folder, key);
  };
  for (std::size_t i = 0; i < sound.size(); ++i) {
    std::string bytes = sound;
    bytes[i] = static_cast<char>(bytes[i] ^ 4);
    EXPECT_FALSE(with(bytes).weights) << i;
    EXPECT_FALSE(with(sound.substr(0, i)).weights) << i;
  }
  EXPECT_FALSE(with(sound + "x").weights);
  EXPECT_TRUE(with(sound).weights);
}

TEST(AttachedFoundation, ReadsItsWeightsFromTheCacheAndRebuildsADamagedOne) {
  const std::filesystem::path folder = fresh_folder("sunder-cache-run");
  const Body body = bare_block(0.5, 1);
  numerics::ThreadPool pool(1);
  const auto attach = [&](const std::filesystem::path& cache) {
    Ledger ledger;
    return attach_foundation(body, {.step = 0.1}, {.time_step = 0.1, .steps = 20}, cache, pool, ledger);
  };
  const AttachedFoundation without = attach({}), first = attach(folder), second = attach(folder);
  EXPECT_TRUE(first.medium->warnings.empty());
  EXPECT_EQ(second.medium->convolution->instantaneous_mass(), without.medium->convolution->instantaneous_mass());
  ASSERT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
  const std::filesystem::path file = std::filesystem::directory_iterator(folder)->path();
  std::filesystem::resize_file(file, 100);
  const AttachedFoundation third = attach(folder);
  ASSERT_EQ(third.medium->warnings.size(), 1u);
  EXPECT_NE(third.medium->warnings[0].find("built anew"), std::string::npos) << third.medium->warnings[0];
  EXPECT_EQ(third.medium->convolution->instantaneous_mass(), without.medium->convolution->instantaneous_mass());
  EXPECT_TRUE(attach(folder).medium->warnings.empty());
  // a folder that cannot be made
  const AttachedFoundation nowhere = attach(file / "below-a-file");
  ASSERT_EQ(nowhere.medium->warnings.size(), 1u);
  EXPECT_NE(nowhere.medium->warnings[0].find("not written"), std::string::npos);
}

TEST(AttachedFoundation, IsAbsentWhereTheRockHasNoDensity) {
  Body body = bare_block(0.5, 1);
  body.materials[0].density = 0.0;
  numerics::ThreadPool pool(1);
  Ledger ledger;
  EXPECT_EQ(attach_foundation(body, {.step = 0.1}, {.time_step = 0.1, .steps = 2}, {}, pool, ledger).medium, nullptr);
}

}  // namespace
}  // namespace sunder::simulation
