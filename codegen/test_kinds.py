"""What the definitions of kinds may not say, and what those of the tree do say."""

import copy
import tempfile
import tomllib
import unittest
from pathlib import Path

from codegen import emit_kind_lists, emit_kinds_cpp, emit_kinds_docs, emit_stage_words, emit_views
from codegen.checks import SchemaError
from codegen.kinds import build_kinds, load_kinds
from codegen.model import load

ROOT = Path(__file__).resolve().parent.parent
SCHEMA = load(ROOT / "interfaces")

MODEL = {"name": "model", "entity": "model", "kind": "plain", "number": 0, "doc": "A body.", "table": "models",
         "body": {"size": [1, 1, 1], "color": [1, 0, 0, 1], "solid": True},
         "word": [{"name": "mass", "type": "number", "unit": "kg", "default": 0, "doc": "Mass."}]}
ARM = {"name": "arm", "entity": "model", "number": 1, "doc": "An arm.", "table": "arms",
       "body": {"size": [1, 1, 1], "color": [1, 0, 0, 1], "solid": True},
       "word": [{"name": "reach", "type": "length", "default": 1, "min": 0, "doc": "How far it reaches."}]}
JOINT = {"name": "joint", "entity": "part", "inside": "arm", "doc": "A joint.", "table": "joints"}
WINDOW = {"name": "window", "entity": "window", "doc": "The window."}
WORLD = {"name": "world", "entity": "world", "doc": "The file."}


def word(**changes):
    return {"name": "reach", "type": "length", "default": 1, "doc": "How far it reaches."} | changes


def without(row, key):
    return {k: v for k, v in row.items() if k != key}


def column(**changes):
    return {"name": "angle", "type": "float64", "unit": "rad", "role": "motion", "writer": "move", "doc": "Angle."} | changes


def viewer(**changes):
    return {"field": "angle", "from": "angle", "quantum": "1/65536 turn", "code": "turn", "when": "changed"} | changes


def tables(**changes):
    """Five kinds; the changes replace entries of the arm."""
    kinds = copy.deepcopy([MODEL, {k: v for k, v in (ARM | changes).items() if v is not None}, JOINT, WINDOW, WORLD])
    return [(f"kinds/{table['name']}.toml", table) for table in kinds]


class Refused(unittest.TestCase):
    def refuse_tables(self, text, parsed):
        with self.assertRaises(SchemaError) as caught:
            build_kinds(parsed, SCHEMA)
        self.assertIn(text, str(caught.exception))
        self.assertEqual(len(str(caught.exception).splitlines()), 1)

    def refuse(self, text, **changes):
        self.refuse_tables(f"kinds/arm.toml: {text}", tables(**changes))

    def refuse_word(self, text, **changes):
        self.refuse(f"word {changes.get('name', 'reach')}: {text}", word=[word(**changes)])

    def test_what_they_are_made_of_is_accepted(self):
        self.assertEqual([k.name for k in build_kinds(tables(), SCHEMA).all], ["model", "arm", "joint", "window", "world"])

    def test_words_of_a_kind_that_stage_does_not_have_say_so_unless_they_say_otherwise(self):
        kept = {"stage": "better", "stage_why": "It is exact."}
        made = build_kinds(tables(not_in_stage="Stage has no arms.", word=[word(name="grasp"), word(name="reach", **kept)]), SCHEMA)
        self.assertEqual([(w.stage, w.stage_why) for w in made.find("arm").words],
                         [("none", "Stage has no arms."), ("better", "It is exact.")])

    def test_a_key_that_nobody_knows(self):
        self.refuse("unknown key 'wrod' (did you mean 'word'?)", wrod=[])
        self.refuse_word("unknown key 'units' (did you mean 'unit'?)", units="m")
        self.refuse("body: unknown key 'colour'", body=ARM["body"] | {"colour": 1})

    def test_a_key_that_is_missing(self):
        self.refuse("doc is missing", doc=None)
        self.refuse("a model, and only a model, has body", body=None)
        self.refuse("table is missing", table=None)
        self.refuse("word reach: doc is missing", word=[without(word(), "doc")])
        self.refuse("word reach: default is missing", word=[without(word(), "default")])

    def test_a_trait_is_given_by_words_that_a_model_may_leave_out(self):
        trait = {"name": "pack", "entity": "trait", "doc": "A battery.", "table": "packs", "given_by": ["charge"],
                 "column": [column(name="stored", unit="J", writer="energy")]}
        charge = word(name="charge", type="number", unit="J", optional=True) | {"default_text": "none"}
        del charge["default"]
        parsed = tables()
        parsed[0][1]["word"].append(charge)
        self.assertEqual([k.name for k in build_kinds([*parsed, ("kinds/pack.toml", trait)], SCHEMA).traits()], ["pack"])
        for changes, text in (({"given_by": ["mass"]}, "given_by: unknown word 'mass'"), ({"table": ""}, "table is missing"),
                              ({"watts": 1}, "watts are what a model or a part of it draws")):
            parsed = tables()
            parsed[0][1]["word"].append(dict(charge))
            self.refuse_tables(f"kinds/pack.toml: {text}", [*parsed, ("kinds/pack.toml", trait | changes)])
        self.refuse("a trait, and only a trait, has given_by", given_by=["charge"])

    def test_a_value_of_another_type(self):
        self.refuse("number '1' is not a whole number", number="1")
        self.refuse("silent 'x' is not a list", silent="x")
        self.refuse("body: solid 1 is not true or false", body=ARM["body"] | {"solid": 1})
        self.refuse("word 3: name 3 is not a text", word=[word(name=3)])
        self.refuse_word("by_hand 'no' is not true or false", by_hand="no")
        self.refuse("column angle: list 'no' is not true or false", column=[column(list="no")])

    def test_a_doc_that_is_no_sentence(self):
        self.refuse("doc must be a sentence", doc="an arm")
        self.refuse_word("doc must be a sentence", doc="")

    def test_a_name_that_is_no_word_or_not_that_of_the_file(self):
        self.refuse_word("name is not a word in lower case", name="Reach")
        parsed = tables()
        parsed[1] = ("kinds/leg.toml", parsed[1][1])
        self.refuse_tables("kinds/leg.toml: the file of 'arm' is kinds/arm.toml", parsed)

    def test_a_type_or_use_or_entity_that_nobody_knows(self):
        self.refuse_word("unknown type 'lenght' (did you mean 'length'?)", type="lenght")
        self.refuse_word("unknown use 'soon'", use="soon")
        self.refuse("unknown entity 'modle' (did you mean 'model'?)", entity="modle")

    def test_units(self):
        self.refuse_word('a number needs a unit ("1" for a plain one)', type="number")
        self.refuse_word("unknown unit 'meter'", type="number", unit="meter")
        self.refuse_word("unknown unit 'meter'", type="number", unit="1/sqrt(meter)")
        self.refuse_word("unknown unit 'm^^2'", type="number", unit="m^^2")
        self.refuse_word("unknown unit 'sqrt(s'", type="number", unit="m/sqrt(s")
        for unit in ("degC", "K/m", "m/s^2/sqrt(Hz)", "m/s or rad/s"):
            build_kinds(tables(word=[word(type="number", unit=unit)]), SCHEMA)
        self.refuse_word("a length has no unit of its own", unit="m")
        self.refuse_word("unknown unit ''", type="twist", default=[0, 0, 0, 0])

    def test_a_pose_without_a_frame(self):
        self.refuse_word("a pose needs a frame", type="pose", default=[0, 0, 0, 0])
        self.refuse_word("frame is for pose, not for a length", frame="X_BS")

    def test_defaults_that_the_type_cannot_have(self):
        self.refuse_word("default '1' is not what a length can be", default="1")
        self.refuse_word("default True is not what a length can be", default=True)
        self.refuse_word("default 2 is not what a flag can be", type="flag", default=2)
        self.refuse_word("default [1, 2] is not what a size can be", type="size", default=[1, 2])
        self.refuse_word("unknown default 'c'", type="choice", default="c", values=[{"word": "a"}, {"word": "b"}])
        self.refuse_word("default -1 is outside of the limits", default=-1, min=0)
        self.refuse_word("default 0 is outside of the limits", default=0, above=0)

    def test_limits_that_say_nothing(self):
        self.refuse_word("min is for", type="text", default="", min=0)
        self.refuse_word("min 'none' is not a number", min="none", default_text="none")
        self.refuse_word("a limit other than 0 is for a count", min=0.5)
        self.refuse_word("max is for a count, a number or an angle that has a min", max=3)
        self.refuse_word("a count needs a min of 0 or more", type="count")
        self.refuse_word("limit names a max, and there is none", limit="kBeams")
        self.refuse_word("clamp is for a number or an integer with min 0", clamp="none is meant")

    def test_tuples_and_choices_and_their_parts(self):
        parts = [{"name": "min", "type": "length"}, {"name": "max", "type": "length"}]
        self.refuse_word("a tuple, and only a tuple, has parts", parts=parts)
        self.refuse_word("a tuple, and only a tuple, has parts", type="tuple")
        self.refuse_word("part 'min' is there twice", type="tuple", default=[0, 1], parts=[parts[0], parts[0]])
        self.refuse_word("part min: unknown type 'lenght'", type="tuple", default=[0], parts=[{"name": "min", "type": "lenght"}])
        self.refuse_word("part min: unknown unit None", type="tuple", default=[0], parts=[{"name": "min", "type": "number"}])
        self.refuse_word("ascending_from is for tuple, not for a length", ascending_from=0)
        self.refuse_word("a choice, and only a choice, has values", type="choice", default="a")
        self.refuse_word("value 'a' is there twice", type="choice", default="a", values=[{"word": "a"}, {"word": "a"}])

    def test_words_of_several_choices(self):
        side = {"name": "side", "enum": "Side", "doc": "Which side.", "values": [{"word": "left"}, {"word": "right"}]}
        self.refuse_word("choices, and only choices, have choices", choices=[side])
        self.refuse_word("choices, and only choices, have choices", type="choices", default=[])
        self.refuse_word("choice side: enum is missing", type="choices", default=["left"], choices=[without(side, "enum")])
        self.refuse_word("choice side: value 'left' is there twice", type="choices", default=["left"],
                         choices=[side | {"values": [{"word": "left"}] * 2}])
        self.refuse_word("choice 'side' is there twice", type="choices", default=["left"] * 2, choices=[side, side])
        self.refuse_word("choice side: unknown default 'rihgt' (did you mean 'right'?)", type="choices", default=["rihgt"], choices=[side])
        self.refuse_word("default ['left', 'right'] is not what choices can be", type="choices", default=["left", "right"],
                         choices=[side])
        self.refuse_tables("kinds/: enum 'Side' is there twice", tables(word=[word(
            type="choices", default=["left"] * 2, choices=[side, side | {"name": "other"}])]))

    def test_changes(self):
        def change(**changes):
            return [{"name": "bend", "doc": "Bends the arm.", "fields": {"angle": "number [rad]"}} | changes]
        self.refuse("change Bend: name is words in lower case", change=change(name="Bend"))
        self.refuse("change bend: doc must be a sentence", change=change(doc="bends"))
        self.refuse("change bend: angle: unknown type 'nubmer' (did you mean 'number'?)", change=change(fields={"angle": "nubmer"}))
        self.refuse("change bend: angle: a number, and only a number, has its unit in [ ]", change=change(fields={"angle": "number"}))
        self.refuse("change bend: unknown gives 'nothing'", change=change(gives="nothing"))
        self.refuse("change 'bend' is there twice", change=change() * 2)
        parsed = tables(change=change())
        parsed[0][1]["change"] = change()
        self.refuse_tables("kinds/: change 'bend' is there twice", parsed)
        self.refuse("a change is of a model that is simulated", number=None, change=change())

    def test_a_body_of_its_own_is_solid(self):
        self.refuse("body: form is for what is solid", body=ARM["body"] | {"solid": False, "form": "a hand"})

    def test_an_rgba_is_read_with_a_color(self):
        color = {"name": "color", "type": "color", "default": [1, 0, 0, 1], "doc": "Color."}
        rgba = {"name": "color_rgba", "type": "rgba", "default": [1, 0, 0, 1], "doc": "Color."}
        self.refuse("word color_rgba: an rgba is read with a color", word=[color, rgba])
        self.refuse("word color_rgba: unknown with 'colour' (did you mean 'color'?)", word=[color, rgba | {"with": "colour"}])
        self.refuse("word color_rgba: only an rgba is read with another word", word=[word(), rgba | {"with": "reach"}])
        build_kinds(tables(word=[color, rgba | {"with": "color"}]), SCHEMA)

    def test_an_indexed_word_of_a_simulated_kind_is_read_by_hand_or_counted(self):
        self.refuse_word("an indexed word is read by hand or counted: counted_by is missing", indexed=True)
        build_kinds(tables(word=[word(indexed=True, by_hand=True)]), SCHEMA)
        joints = {"name": "joints", "type": "count", "default": 0, "min": 0, "doc": "How many joints."}
        reach = word(indexed=True, counted_by="joints")
        build_kinds(tables(word=[joints, reach]), SCHEMA)
        self.refuse("word reach: unknown counted_by 'joints'", word=[reach, joints])  # it is read before
        self.refuse("word reach: unknown counted_by 'joint' (did you mean 'joints'?)", word=[joints, reach | {"counted_by": "joint"}])
        self.refuse("word reach: unknown counted_by 'span'", word=[word(name="span"), reach | {"counted_by": "span"}])
        for changes in ({"indexed": False}, {"by_hand": True}, {"optional": True}):
            self.refuse("word reach: counted_by is for an indexed word", word=[joints, reach | changes])
        self.refuse("word reach: counted_by is for angle, ", word=[joints, reach | {"type": "flag"}])

    def test_what_is_there_twice(self):
        self.refuse("word 'reach' is there twice", word=[word(), word()])
        self.refuse("word 'reach' is there twice", old={"reach": ""})
        self.refuse("word 'reach' is there twice", silent=["reach"])
        self.refuse("member 'reach' is there twice", word=[word(), word(name="span", member="reach")])
        self.refuse("word mass: every model has that word (kinds/model.toml)", word=[word(name="mass")])
        self.refuse("interface 'gripper' is there twice", interface=[{"name": "gripper", "index": "count"}] * 2)
        self.refuse_tables("kinds/: number 0 is there twice", tables(number=0))
        self.refuse_tables("kinds/: table 'joints' is there twice", tables(table="joints"))

    def test_numbers_have_no_gap_and_belong_to_models(self):
        self.refuse_tables("the numbers of models count from 0 without a gap", tables(number=2))
        parsed = tables()
        parsed[2][1]["number"] = 2
        self.refuse_tables("kinds/joint.toml: number is for a model, not for a part", parsed)
        self.refuse("kind names a number of ModelKind", number=None, kind="arm")

    def test_the_kinds_that_must_be_there(self):
        self.refuse_tables('a model named "model" with number 0 is expected', tables()[1:])
        self.refuse_tables("exactly one window is expected", [t for t in tables() if t[1]["name"] != "window"])

    def test_a_part_of_a_type_that_nobody_knows(self):
        parsed = tables()
        parsed[2][1]["inside"] = "amr"
        self.refuse_tables("kinds/joint.toml: unknown inside 'amr' (did you mean 'arm'?)", parsed)

    def test_voltages(self):
        def refuse(text, *voltages, name="aio", measured="measured_tick"):
            columns = [column(), column(name=measured, type="uint64", unit="ticks"), column(name="all", list=True)]
            self.refuse(f"interface {name}: voltages: {text}", column=columns,
                        interface=[{"name": name, "index": "count", "voltages": list(voltages)}])

        refuse("unknown from 'angel' (did you mean 'angle'?)", {"from": "angel", "volts": 1})
        refuse("unknown from 'all'", {"from": "all", "volts": 1})
        refuse("volts is missing", {"from": "angle"})
        refuse("they are for the aio of a sensor", {"from": "angle", "volts": 1}, name="gripper")
        refuse("they are for the aio of a sensor", {"from": "angle", "volts": 1}, measured="moved_tick")

    def test_interfaces(self):
        self.refuse("interface griper: unknown name 'griper' (did you mean 'gripper'?)",
                    interface=[{"name": "griper", "index": "count"}])
        self.refuse("interface gripper: unknown index 'robots' (did you mean 'robot'?)",
                    interface=[{"name": "gripper", "index": "robots"}])
        self.refuse("interface gripper: unknown when 'scaner' (did you mean 'scanner'?)",
                    interface=[{"name": "gripper", "index": "count", "when": "scaner"}])

    def test_an_old_type_that_is_a_type(self):
        self.refuse("old_types: model is a type, see kinds/model.toml", old_types={"model": "x"})

    def test_old_types_and_words_that_become_nothing_known(self):
        def refuse(text, **entry):
            self.refuse(text, old={"grasp": {"instead": "write reach", **entry}})

        refuse("old grasp: exactly one of to, counts, nested and by_hand is expected")
        refuse("old grasp: exactly one of to, counts, nested and by_hand is expected", to=["reach"], counts=True)
        refuse("old grasp: counts is about parts, and there is no part", counts=True)
        refuse("old grasp: unknown word 'raech' (did you mean 'reach'?)", to=["raech"])
        refuse("old grasp: unknown part 'jiont' (did you mean 'joint'?)", part="jiont", counts=True)
        refuse("old grasp: unknown word 'reach'", part="joint", to=["reach"])
        self.refuse("old grasp: a text or a table is expected", old={"grasp": 1})
        self.refuse("old_types claw: unknown type 'amr' (did you mean 'arm'?)", old_types={"claw": {"instead": "x", "type": "amr"}})
        self.refuse("old_types claw: type is missing", old_types={"claw": {"instead": "x"}})
        self.refuse("old_types claw: unknown word 'size'", old_types={"claw": {"instead": "x", "type": "arm", "words": {"size": 1}}})

    def test_engines_and_checks_are_known(self):
        self.refuse_word("unknown engine 'arna' (did you mean 'arena'?)", engine="arna")
        self.refuse_word("check is for text, not for a length", check="known_material")
        self.refuse_word("unknown check 'known_materials' (did you mean 'known_material'?)", name="note", type="text", default="", check="known_materials")

    def test_what_differs_from_stage_says_why(self):
        self.refuse_word("unknown stage 'beter' (did you mean 'better'?)", stage="beter", stage_why="It is.")
        self.refuse_word("stage_why is for what is not the same as in Stage, and needed there", stage="better")
        self.refuse_word("stage_why is for what is not the same as in Stage, and needed there", stage_why="It is.")
        self.refuse("silent_why: nothing is said of debug", silent=["debug"])
        self.refuse("silent_why: unknown word 'debgu' (did you mean 'debug'?)", silent=["debug"], silent_why={"debgu": "Idle."})

    def test_a_page_tells_every_word_of_stage(self):
        page = emit_stage_words.emit(load_kinds(ROOT / "kinds", SCHEMA))[emit_stage_words.PAGE]
        self.assertIn("| `friction` | same |  |", page)
        self.assertIn("| `gui_nose` | better | It is drawn;", page)
        self.assertIn("`show_blocks`, `show_flags`,", page)

    def test_columns(self):
        self.refuse("column angle: a float64 needs a unit", column=[without(column(), "unit")])
        self.refuse("column angle: unknown type 'double'", column=[column(type="double")])
        self.refuse("column angle: unknown role 'moves'", column=[column(role="moves")])
        self.refuse("column angle: unknown writer 'moves' (did you mean 'move'?)", column=[column(writer="moves")])
        self.refuse("column angle: writer is missing", column=[without(column(), "writer")])
        self.refuse("column angle: a pose needs a frame", column=[column(type="pose", unit="m, m, m, rad")])
        self.refuse("column angle: frame 'robot' is not a monogram", column=[column(frame="robot")])
        self.refuse("column angle: 2 units for a value of 1", column=[column(unit="m, rad")])
        self.refuse("column angle: unknown per 'ray'", column=[column(per="ray")])
        self.refuse("column angle: unknown word of a float64 'raech' (did you mean 'reach'?)", column=[column(word="raech")])
        self.refuse("column angle: unknown word of a uint64 'reach'", column=[without(column(type="uint64", word="reach"), "unit")])
        self.refuse("column 'angle' is there twice", column=[column(), column()])

    def test_columns_without_a_table(self):
        parsed = tables()
        parsed[2][1].pop("table")
        parsed[2][1]["column"] = [column()]
        self.refuse_tables("kinds/joint.toml: columns need a table", parsed)

    def test_what_a_viewer_gets(self):
        def refuse(text, **changes):
            self.refuse(text, column=[column()], viewer=[viewer(**changes)])

        refuse("viewer angle: unknown from 'angel' (did you mean 'angle'?)", **{"from": "angel"})
        refuse("viewer angle: unknown part of angle 'x'", **{"from": "angle.x"})
        refuse("viewer angle: unknown code 'json2' (did you mean 'json'?)", code="json2")
        refuse("viewer angle: unknown when 'always'", when="always")
        refuse("viewer angle: unknown quantum 'degrees'", quantum="degrees")
        refuse("viewer angle: unit is for json", unit="rad")
        refuse("viewer angle: what is told at the start, and only that, travels as json", when="start")
        refuse("viewer angle: unknown from 'reach'", **{"from": "reach"})  # a word never changes
        self.refuse("viewer field 'angle (running)' is there twice", column=[column()], viewer=[viewer(), viewer()])
        build_kinds(tables(column=[column()], viewer=[viewer(), without(viewer(field="reach", code="json", when="start",
                                                                        **{"from": "reach"}), "quantum")]), SCHEMA)

    def test_fields_of_records(self):
        hit = {"name": "Hit", "doc": "A hit.", "fields": [{"name": "range", "type": "float64", "unit": "m", "doc": "Range."}]}
        hits = {"name": "hits", "type": "Hit", "list": True, "role": "sensed", "writer": "sense", "doc": "Hits."}
        self.refuse("record Hit: field range: a float64 needs a unit",
                    record=[hit | {"fields": [without(hit["fields"][0], "unit")]}])
        self.refuse("viewer angle: unknown part of hits 'rnge' (did you mean 'range'?)", record=[hit], column=[hits],
                    viewer=[viewer(**{"from": "hits.rnge"})])
        build_kinds(tables(record=[hit], column=[hits], viewer=[viewer(**{"from": "hits.range"})]), SCHEMA)


class Places(unittest.TestCase):
    def test_a_fault_of_a_word_is_told_with_its_line(self):
        with tempfile.TemporaryDirectory() as folder:
            for path in (ROOT / "kinds").glob("*.toml"):
                text = path.read_text(encoding="utf-8")
                (Path(folder) / path.name).write_text(text.replace('"ignore_zloc"\ntype = "flag"', '"ignore_zloc"\ntype = "flog"'))
            line = 1 + (ROOT / "kinds/fiducial.toml").read_text().splitlines().index('name = "ignore_zloc"')
            with self.assertRaises(SchemaError) as caught:
                load_kinds(Path(folder), SCHEMA)
        self.assertEqual(str(caught.exception), f"kinds/fiducial.toml:{line - 1}: word ignore_zloc: "
                                                "unknown type 'flog' (did you mean 'flag'?)")

    def test_a_file_that_is_no_toml(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "arm.toml").write_text("name = ")
            with self.assertRaises(SchemaError) as caught:
                load_kinds(Path(folder), SCHEMA)
        self.assertIn("kinds/arm.toml: ", str(caught.exception))


class Checked(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kinds = load_kinds(ROOT / "kinds", SCHEMA)

    def test_the_kinds_of_the_tree_are_those_of_stage_and_our_own(self):
        ours = {path.stem for path in (ROOT / "kinds").glob("*.toml") if "not_in_stage" in tomllib.loads(path.read_text(encoding="utf-8"))}
        self.assertEqual(sorted(k.name for k in self.kinds.models() if k.name not in ours),
                         ["actuator", "blinkenlight", "blobfinder", "bumper", "camera", "fiducial",
                          "gripper", "lightindicator", "model", "position", "ranger", "wifi"])
        self.assertEqual([k.name for k in self.kinds.all if k.entity != "model"], ["block", "sensor", "pack", "window", "world"])

    def test_columns_of_all_models_are_those_of_the_world(self):
        listed = (ROOT / "playhouse/world/columns.h").read_text(encoding="utf-8")
        columns = self.kinds.find("model").state.columns
        for c in columns:
            self.assertIn(f'"models.{c.name}", Role::k{c.role.title()},', listed)
        self.assertEqual(listed.count("Column{"), len(columns))

    def test_every_file_is_read(self):
        names = {tomllib.loads(p.read_text(encoding="utf-8"))["name"] for p in (ROOT / "kinds").glob("*.toml")}
        self.assertEqual({k.name for k in self.kinds.all}, names)


class Generated(unittest.TestCase):
    """A kind that becomes simulated needs no other file for its words, description, reading, writing and page."""

    def test_a_number_is_all_that_the_words_of_a_kind_need(self):
        parsed = [(f"kinds/{p.name}", tomllib.loads(p.read_text(encoding="utf-8"))) for p in (ROOT / "kinds").glob("*.toml")]
        camera = next(t for _, t in parsed if t["name"] == "camera")
        freed = camera["number"]
        for key in ("number", "table", "watchable", "record", "column", "viewer", "change"):
            del camera[key]
        for _, t in parsed:
            t.update({"number": t["number"] - 1} if t.get("number", 0) > freed else {})
        build_kinds(copy.deepcopy(parsed), SCHEMA)
        numbers = [t["number"] for _, t in parsed if "number" in t]
        camera.update(number=len(numbers), table="cameras")
        files = emit_kinds_cpp.emit(build_kinds(parsed, SCHEMA))
        descs = files["playhouse/scene/generated/kind_descs.h"]
        self.assertIn(f"  kCamera = {len(numbers)},\n", descs)
        self.assertIn("  std::optional<CameraDesc> camera;", descs)
        self.assertIn("  double fov_horizontal = geom::radians(70);\n", descs)
        reading = files["playhouse/scene/generated/read_kinds.cc"]
        self.assertIn('properties.tuple("range", "LL", range, "[min max]");', reading)
        self.assertIn("read(properties, to.camera.emplace());", reading)
        writing = files["playhouse/scene/generated/write_kinds.cc"]
        self.assertIn('to.tuple("range", "LL", range);', writing)
        self.assertIn("if (from.camera) write(*from.camera, {}, words);", writing)
        self.assertIn('{.name = "pantilt", .use = Support::kRead,', files["playhouse/scene/generated/kind_tables.cc"])

    def test_a_word_that_is_counted_is_a_list(self):
        words = [{"name": "joints", "type": "count", "default": 0, "min": 0, "doc": "How many joints."},
                 word(indexed=True, counted_by="joints", min=0)]
        fields = [without(viewer(field="reach", code="json", when="start", **{"from": "reach"}), "quantum")]
        kinds = build_kinds(tables(word=words, viewer=fields), SCHEMA)
        files = emit_kinds_cpp.emit(kinds) | emit_views.emit(kinds)
        self.assertIn("  std::vector<double> reach;\n", files["playhouse/scene/generated/kind_descs.h"])
        self.assertIn('  to.reach = read_each(properties, "reach", "joints", to.joints, reach, [&](std::string_view key, double& each) {\n'
                      "    each = properties.length(key, each);\n"
                      '    require(each >= 0, properties, key, "must not be negative");\n'
                      "  });\n", files["playhouse/scene/generated/read_kinds.cc"])
        self.assertIn("list(model.arm->reach, [](const auto& each) { return number(each); })",
                      files["playhouse/replicate/generated/views.cc"])
        self.assertIn("  reach?: number[];\n", files["web/src/protocol/generated/views.ts"])

    def test_a_sensor_with_voltages_needs_no_device_of_its_own(self):
        kinds = build_kinds(tables(column=[column(), column(name="measured_tick", type="uint64", unit="ticks")],
                                   interface=[{"name": "aio", "index": "count", "voltages": [{"from": "angle", "volts": 0.5}]}]), SCHEMA)
        files = emit_kind_lists.emit(kinds) | emit_kinds_docs.emit(kinds)
        self.assertIn("std::unique_ptr<SimulatedDevice> make_aio_device(", files["playhouse/bridge/generated/voltages.cc"])
        self.assertIn("    if (sensors.measured_tick[row] != world.tick()) return false;\n"
                      "    voltages = {static_cast<float>(0.5 * sensors.angle[row])};\n", files["playhouse/bridge/generated/voltages.cc"])
        self.assertIn("    {21, scene::ModelKind::kArm, make_aio_device},", files["playhouse/bridge/generated/device_makers.h"])
        self.assertIn("| 0.5 V per rad of `angle` |", files["docs/kinds/arm.md"])

    def test_a_bar_in_a_table_of_a_page_is_escaped(self):
        page = emit_kinds_docs.emit(load_kinds(ROOT / "kinds", SCHEMA))["docs/kinds/position.md"]
        self.assertIn('| `"diff" \\| "omni" \\| "walk" \\| "car"` |', page)

    def test_the_sensor_of_contributing_is_one(self):
        text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
        example = tomllib.loads(text.split("```toml\n")[1].split("```")[0])
        files = [(f"kinds/{path.name}", tomllib.loads(path.read_text(encoding="utf-8"))) for path in sorted((ROOT / "kinds").glob("*.toml"))]
        example["number"] = 1 + max(each.get("number", 0) for _, each in files)
        kinds = build_kinds([*files, ("kinds/altimeter.toml", example)], SCHEMA)
        self.assertTrue(kinds.find("altimeter").measures and kinds.find("altimeter").may_be_watched)


if __name__ == "__main__":
    unittest.main()
