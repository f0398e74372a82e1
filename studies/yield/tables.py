"""Tables and fits of indentation beyond yield: tables.py FOLDER_OF_RUNS."""

import sys
from pathlib import Path

import numpy as np

from runs import Run

HERE = Path(__file__).parent
DEPTHS = (1.5, 2, 3, 5, 8, 13, 20, 35, 60, 100, 200, 400, 800, 1600)
RESOLVED = 12  # nodes in contact from which a force is used
PARTS = np.linspace(0, 1, 21)


class Curve:
    """ln of a quantity as Σ b_k (ln d)^k: smooth, and known at the onset of yield."""

    def __init__(self, d, values, powers, onset=1.0, weights=None):
        x, self.powers, self.onset = np.log(d), powers, onset
        matrix = np.stack([x**k for k in powers], 1)
        weights = np.ones_like(x) if weights is None else weights
        scale = np.abs(matrix).max(0)
        solution = np.linalg.lstsq(matrix / scale * weights[:, None], np.log(values / onset) * weights, rcond=None)[0]
        self.terms = solution / scale
        self.deviations = values / self(d) - 1

    def __call__(self, d):
        x = np.log(np.maximum(np.asarray(d, float), 1.0))
        return self.onset * np.exp(sum(b * x**k for b, k in zip(self.terms, self.powers)))

    def words(self, name):
        return f"{name}," + ",".join(f"{b:.6e}" for b in self.terms) + f",{np.sqrt(np.mean(self.deviations**2)):.4f},{np.abs(self.deviations).max():.4f}"


def loading_points(runs):
    """(d, f, a, elements) of readings that are resolved and beyond the onset."""
    points = [(row[0], row[1], row[2], run.elements) for run in runs for row in run.load if row[3] >= RESOLVED and row[0] > 1.02]
    return np.array(sorted(points)).T


class Law:
    """Everything that is universal at one Poisson's ratio."""

    def __init__(self, runs):
        self.runs = runs
        d, f, a, elements = loading_points(runs)
        weights = elements / 40
        terms = 7 if len(runs) > 10 else 5
        self.hardness = Curve(d, f / d**1.5, range(2, 2 + terms), weights=weights)  # f/d^{3/2}
        self.area = Curve(d, a**2 / d, range(2, 2 + terms), weights=weights)  # a²/d
        depths = np.array([run.depth for run in runs])
        weights = np.array([run.elements for run in runs]) / 40
        released = np.array([run.released for run in runs])
        way = np.array([run.depth - run.residual_depth for run in runs])
        # The edge of the contact is at a node, so that the last force is beside the law by up to a few percent; what is
        # released is beside by 4/3 of that, and the way by 1/3 (measured: ν = 0.3, d = 200 and 400, two step sizes).
        force = np.array([run.force for run in runs])
        beside = force / self.force(depths)
        few = min(terms, 4 if len(set(depths)) < 7 else 5 if len(set(depths)) < 12 else 6)
        self.way = Curve(depths, way / depths / beside ** (1 / 3), range(2, 2 + few), weights=weights)
        self.exponent = Curve(depths, force * way / released - 1, range(1, 4), 1.5, weights)
        regained = released / self.work(depths) / beside ** (4 / 3)
        self.restitution2 = Curve(depths, regained, range(2, 2 + few), weights=weights)

    def force(self, d):
        d = np.asarray(d, float)
        return d**1.5 * self.hardness(d)

    def work(self, depths):
        """∫ f dd by the trapezoidal rule on a fine logarithmic grid, from the exact 2/5 at the onset."""
        grid = np.exp(np.linspace(0, np.log(np.max(depths)), 40001))
        integrand = self.force(grid)
        works = 0.4 + np.append(0, np.cumsum(0.5 * (integrand[1:] + integrand[:-1]) * np.diff(grid)))
        return np.interp(depths, grid, works)

    def monotone(self):
        d = np.exp(np.linspace(0, np.log(max(run.depth for run in self.runs)), 4001))
        return bool(np.all(np.diff(self.force(d)) > 0) and np.all(np.diff(d * (1 - self.way(d))) > 0))

    def near(self, curve, coordinates, d):
        """Standard error of a curve at d: the scatter of what was fitted within a factor of 2.2."""
        there = np.abs(np.log(coordinates / d)) < np.log(2.2)
        return float(np.sqrt(np.mean(curve.deviations[there] ** 2)))


def read(folder):
    laws = {}
    runs = [Run(path) for path in sorted(Path(folder).glob("nu*.csv"))]
    for poisson in sorted({run.poisson for run in runs}):
        laws[poisson] = [run for run in runs if run.poisson == poisson and run.size == 40 and run.depth > 1]
    return laws, runs


def by_mesh(runs, coarse=24, fine=40):
    """Relative changes of force law, ε² and way from runs of at most `coarse` to those of at least `fine` elements."""
    two = [Law([run for run in runs if run.elements <= coarse]), Law([run for run in runs if run.elements >= fine])]
    return lambda d: [abs(float(getattr(two[0], of)(d) / getattr(two[1], of)(d)) - 1) for of in ("force", "restitution2", "way")]


def main():
    all_runs, _ = read(sys.argv[1])
    runs = all_runs[0.3]
    law, change = Law(runs), by_mesh(runs)
    d_points = loading_points(runs)[0]
    depths = np.array([run.depth for run in runs])
    with open(HERE / "loading.csv", "w", encoding="utf-8") as file:
        print("# Loading by a rigid paraboloid, nu = 0.3: depth, force, radius of contact over those at the onset of yield", file=file)
        print("d,f,f_error,a,W_load", file=file)
        grid = np.exp(np.linspace(0, np.log(1600), 60))
        for d in grid:
            error = float(law.force(d)) * np.hypot(change(d)[0], law.near(law.hardness, d_points, d) / 3) if d > 1 else 0.0
            print(f"{d:.6g},{law.force(d):.6g},{error:.2g},{np.sqrt(d * law.area(d)):.5g},{law.work(d):.6g}", file=file)
    fine = {run.depth: run for run in runs if run.elements >= 40}
    coarse = {run.depth: run for run in runs if run.elements == 20 and run.steps == 40}
    with open(HERE / "unloading.csv", "w", encoding="utf-8") as file:
        print("# Unloading from d_max, nu = 0.3: force over that at d_max on 21 places from the residual depth to d_max", file=file)
        print("d_max,part,d_over_d_max,f_over_f_max,error", file=file)
        for depth in DEPTHS:
            run, rough = fine.get(depth, coarse.get(depth)), coarse.get(depth)
            if run is None:
                continue
            d, shape = run.shape(PARTS)
            for part, at, value, other in zip(PARTS, d, shape, rough.shape(PARTS)[1]):
                print(f"{depth:g},{part:.2f},{at / depth:.5f},{value:.5f},{abs(value - other):.5f}", file=file)
    with open(HERE / "restitution.csv", "w", encoding="utf-8") as file:
        print("# What is regained, by Poisson's ratio; V_over_V_y is of the loading work", file=file)
        print("nu,d_max,V_over_V_y,f_max,d_r,d_r_error,n,W_unload_over_W_load,W_ratio_error,restitution,curvature_of_impression", file=file)
        for poisson, of_nu in all_runs.items():
            own = law if poisson == 0.3 else Law(of_nu)
            places = np.array([run.depth for run in of_nu])
            for depth in sorted(set(DEPTHS) & set(places)):
                run = max((run for run in of_nu if run.depth == depth), key=lambda run: run.elements)
                ratio = float(own.restitution2(depth))
                c = change(depth)
                # Few runs say little of their scatter: that of nu = 0.3 stands for them.
                scatter = max(own.near(own.restitution2, places, depth), law.near(law.restitution2, depths, depth))
                error = ratio * np.hypot(c[1], scatter)
                way = float(own.way(depth))
                scatter = max(own.near(own.way, places, depth), law.near(law.way, depths, depth))
                way_error = way * np.hypot(c[2], scatter)
                print(
                    f"{poisson:g},{depth:g},{np.sqrt(own.work(depth) / 0.4):.5g},{own.force(depth):.6g},"
                    f"{depth * (1 - way):.6g},{depth * way_error:.2g},{own.exponent(depth):.4f},{ratio:.5f},{error:.2g},{np.sqrt(ratio):.5f},{run.impression():.4f}",
                    file=file,
                )
    with open(HERE / "fits.csv", "w", encoding="utf-8") as file:
        print("# hardness f/d^1.5, area a^2/d, way 1 - d_r/d, exponent n, restitution2 W_unload/W_load; of each\n# ln(quantity / its value at d = 1) = sum of b_k (ln d)^k, by k from the first power;\n# the last two: rms and largest relative deviation of what was fitted", file=file)
        for poisson, of_nu in all_runs.items():
            own = law if poisson == 0.3 else Law(of_nu)
            for name in ("hardness", "area", "way", "exponent", "restitution2"):
                curve = getattr(own, name)
                print(f"nu={poisson:g},{curve.powers[0]}," + curve.words(name), file=file)
            print(f"# nu={poisson:g} monotone: {own.monotone()}", file=file)
    for run in sorted(runs, key=lambda run: (run.depth, run.elements, run.steps)):
        e2 = run.released / law.work(run.depth)
        print(f"d {run.depth:6g} n {run.elements} s {run.steps} f/fit-1 {run.force / law.force(run.depth) - 1:+.4f} "
              f"e2 {e2:.5f} {e2 / law.restitution2(run.depth) - 1:+.4f} way {(run.depth - run.residual_depth) / run.depth / law.way(run.depth) - 1:+.4f} "
              f"n {run.force * (run.depth - run.residual_depth) / run.released - 1:.3f} imbalance {run.imbalance:.4f}")


if __name__ == "__main__":
    main()
