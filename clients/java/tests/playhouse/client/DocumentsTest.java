package playhouse.client;

import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** The Java that README.md shows compiles. */
public final class DocumentsTest {
  private static final Pattern BLOCK = Pattern.compile("^```java\n(.*?)^```", Pattern.MULTILINE | Pattern.DOTALL);

  @Rule public final TemporaryFolder folder = new TemporaryFolder();

  @Test
  public void theBlocksOfTheReadmeCompile() throws IOException {
    String text = Files.readString(Path.of(System.getProperty("playhouse.readme")));
    List<String> blocks = BLOCK.matcher(text).results().map(MatchResult::group)
        .map(block -> block.substring("```java\n".length(), block.length() - "```".length())).toList();
    assertTrue(blocks.size() + " blocks", blocks.size() >= 3);
    for (String block : blocks) {
      StringWriter said = new StringWriter();
      boolean compiled = task(block.contains("class ") ? block : wrapped(block), said).call();
      assertTrue(block + said, compiled);
    }
  }

  private JavaCompiler.CompilationTask task(String source, StringWriter said) {
    String name = source.replaceAll("(?s).*?class (\\w+).*", "$1");
    JavaFileObject file =
        new SimpleJavaFileObject(URI.create("string:///" + name + ".java"), JavaFileObject.Kind.SOURCE) {
          @Override
          public CharSequence getCharContent(boolean ignored) {
            return source;
          }
        };
    List<String> options = List.of("-proc:none", "-d", folder.getRoot().getPath());
    return ToolProvider.getSystemJavaCompiler().getTask(said, null, null, options, null, List.of(file));
  }

  /** Statements of a program that has a client. */
  private static String wrapped(String block) {
    String imports = block.lines().filter(line -> line.startsWith("import ")).collect(Collectors.joining("\n"));
    String rest = block.lines().filter(line -> !line.startsWith("import ")).collect(Collectors.joining("\n"));
    return "import playhouse.client.*;\n" + imports + "\nclass Block {\n  static void run(Client client) {\n" + rest
        + "\n  }\n}\n";
  }
}
