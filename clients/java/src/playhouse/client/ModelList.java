package playhouse.client;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import playhouse.client.wire.SimulationMessages;
import playhouse.client.wire.SimulationMessages.PropertyReq;
import playhouse.client.wire.Text;

/**
 * The simulator's list of models and their devices: lines of text in a property of the interface simulation.
 */
final class ModelList {
  private static final Pattern PORT_OR_INDEX = Pattern.compile("[0-9]{1,9}");
  private static final Pattern ID = Pattern.compile("[0-9]{1,18}");
  private static final Pattern SPACES = Pattern.compile("\\s+");

  /**
   * All models of a simulation device's world. Throws RequestRefusedException if the simulator does not
   * report them.
   */
  static List<Model> request(Device simulator) {
    List<Model> found = new ArrayList<>();
    long index = 0;
    while (true) {
      PropertyReq question = new PropertyReq(Text.field(""), Text.field("models"), index, new byte[0]);
      PropertyReq answer = simulator.request(SimulationMessages.REQ_GET_PROPERTY, question).orElse(question);
      found.addAll(parse(Text.of(answer.value())));
      if (answer.index() == 0) {
        return found;
      }
      if (answer.index() <= index) {
        throw new WireException("the list of models goes on at " + answer.index() + " after " + index);
      }
      index = answer.index();
    }
  }

  /** The models of one answer, one per line: id, name, type, parent and devices, separated by TABs. */
  static List<Model> parse(String lines) {
    return lines.lines().filter(line -> !line.isEmpty()).map(ModelList::parseLine).toList();
  }

  /** For each model, in order: itself and all its descendants, in the order of the list. */
  static List<List<Model>> families(List<Model> models) {
    List<List<Model>> found = new ArrayList<>();
    List<Integer> parents = new ArrayList<>();
    Map<String, Integer> places = new HashMap<>();  // of equal names the last one so far
    for (Model model : models) {  // parents come before children
      found.add(new ArrayList<>(List.of(model)));
      parents.add(places.get(model.parent()));
      places.put(model.name(), parents.size() - 1);
      for (Integer above = parents.get(parents.size() - 1); above != null; above = parents.get(above)) {
        found.get(above).add(model);
      }
    }
    return found;
  }

  private static Model parseLine(String line) {
    String[] fields = line.split("\t", -1);
    if (fields.length != 5) {
      throw new WireException(
          "a line of the list of models has " + fields.length + " fields instead of 5: '" + line + "'");
    }
    if (!ID.matcher(fields[0]).matches()) {
      throw new WireException("'" + fields[0] + "' in the list of models is not an id");
    }
    String name = unescaped(fields[1]);
    List<DeviceAddress> devices = SPACES.splitAsStream(fields[4])
        .filter(word -> !word.isEmpty()).map(word -> parseDevice(word, name)).toList();
    return new Model(name, unescaped(fields[2]), unescaped(fields[3]), devices, Long.parseLong(fields[0]));
  }

  private static DeviceAddress parseDevice(String word, String model) {
    String[] parts = word.split(":", 3);
    if (parts.length != 3 || !PORT_OR_INDEX.matcher(parts[0]).matches() || !PORT_OR_INDEX.matcher(parts[2]).matches()) {
      throw new WireException("'" + word + "' in the list of models is not PORT:INTERFACE:INDEX");
    }
    return new DeviceAddress(Integer.parseInt(parts[0]), parts[1], Integer.parseInt(parts[2]), model);
  }

  private static String unescaped(String field) {
    StringBuilder out = new StringBuilder();
    for (int i = 0; i < field.length(); ++i) {
      char next = field.charAt(i) == '\\' && i + 1 < field.length() ? field.charAt(i + 1) : '\0';
      switch (next) {
        case 't' -> out.append('\t');
        case 'n' -> out.append('\n');
        case '\\' -> out.append('\\');
        default -> {
          out.append(field.charAt(i));
          continue;
        }
      }
      ++i;
    }
    return out.toString();
  }

  private ModelList() {}
}
