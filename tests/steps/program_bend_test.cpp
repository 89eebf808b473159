// A program with bending: four models, and a curtain whose rings are vertices by number.
#include "scene/mesh.h"
#include "support/program_runner.h"

namespace program_bend_test {

class BendProgram : public ProgramDirectory {
 protected:
  const StepProgram step05 = program_called("step05_bend");

  // 0.1 s of a scene, without pictures.
  Outcome run_to(const std::string& out, const StepProgram& program, Arguments arguments) const {
    arguments.insert(arguments.end(), {"--end", "0.1", "--no-pictures", "--out", out});
    const Outcome outcome = run(program, arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("warning"), std::string::npos) << outcome.out;
    return outcome;
  }
  std::string final_state(const std::string& out) const {
    return read_all(directory / out / "final.obj") +
           read_all(directory / out / "final_velocities.csv");
  }
};

// The step's own scene with other lines in [bend] and [damping].
std::string curtain_with(const std::string& bend, const std::string& damping) {
  std::string text = read_all(program_called("step05_bend").scene());
  for (const auto& [table, lines] : {std::pair("[bend]\n", bend), {"[damping]\n", damping}}) {
    const size_t at = text.find(table), end = text.find("\n[", at);
    EXPECT_NE(at, text.npos);
    text.replace(at, end - at, table + lines);
  }
  return text;
}

// With the k that gives all of them one modulus; springs have none.
TEST_F(BendProgram, FourModelsDrawFourCurtains) {
  std::vector<std::string> states;
  for (const std::string model : {"dihedral", "bridson", "quadratic", "springs"}) {
    const std::string stiffness = model == "springs" ? "k = 1" : "B = 0.0001";
    write(model + ".toml", curtain_with("model = \"" + model + "\"\n" + stiffness, "bend = 1e-6"));
    run_to(model, step05, {model + ".toml"});
    const Table log = read_table(directory / model / "log.csv");
    EXPECT_GT(log.at("bend").back(), 0) << model;
    EXPECT_LT(log.at("max_stretch").back(), 1.1) << model;
    for (const std::string& other : states) EXPECT_TRUE(final_state(model) != other) << model;
    states.push_back(final_state(model));
  }
}

TEST_F(BendProgram, WithoutBendingItIsStep04) {
  const std::string scene = step05.scene();
  run_to("five", step05, {scene, "--without", "bend"});
  run_to("four", program_called("step04_cg"), {scene, "--without", "bend"});
  EXPECT_TRUE(final_state("five") == final_state("four"));
  EXPECT_EQ(columns_of(read_all(directory / "five/log.csv")),
            columns_of(read_all(directory / "four/log.csv")));
}

// One hinge. All of its vertices are held, and one of them lies on the edge.
TEST_F(BendProgram, SaysThatAFlapIsPressedToALine) {
  write("start.obj", "v 0 0 0\nv 1 0 0\nv 0 0 -1\nv 0.5 0 -0.5\nf 1 2 3\nf 2 4 3\n");
  write("scene.toml",
        "[cloth]\nsize = [1.0, 1.0]\ncells = [1, 1]\ndiagonals = \"same\"\ndensity = 0.2\n"
        "pins = [0, 1, 2, 3]\n[stretch]\nk = 1000.0\n[bend]\nk = 1.0\n[time]\nh = 0.01\nend = 0.1\n"
        "[start]\npositions = \"start.obj\"\n");
  const Outcome outcome = run(step05, {"scene.toml", "--no-pictures", "--out", "out"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("1 hinge has a flap that is pressed to a line, and cannot bend"),
            std::string::npos)
      << outcome.out;
}

TEST_F(BendProgram, ItsRingsHaveNoNumbersOnOtherCells) {
  const Outcome refused = run(step05, {"--cells", "24", "--out", "out"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(lines_of(refused.err).size(), 1u) << refused.err;
  EXPECT_NE(refused.err.find("scene.toml:8: --cells 24: pin 1574 is the number of a vertex"),
            std::string::npos)
      << refused.err;
  EXPECT_EQ(files_in(directory), std::vector<std::string>{});
}

}  // namespace program_bend_test
