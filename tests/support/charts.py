"""Charts of gnuplot."""
import pathlib
import subprocess
import tempfile


def gnuplot(size, script, blocks, path):
    """The script draws what it calls 'data', whose index 0, 1, ... are the blocks, in pixels of `size`."""
    with tempfile.TemporaryDirectory() as folder:
        where = pathlib.Path(folder)
        (where / "data").write_text("\n\n\n".join(blocks) + "\n")
        (where / "script").write_text(f"set terminal pngcairo noenhanced size {size} font 'sans,11'\nset output 'chart'\n"
                                      f"set grid\n{script}\n")
        subprocess.run(["gnuplot", "script"], cwd=where, check=True)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes((where / "chart").read_bytes())
