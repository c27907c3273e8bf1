// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneForces.H"
#include "samples/samples.H"

#include <gtest/gtest.h>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar Gs = 5e-6;

string material(const string& others)
{
    return "type membrane; density 1000; shearModulus 5e-6; " + others;
}


//- Square of this size with a node inside, not in its middle
shapeMesh square(const scalar size)
{
    shapeMesh mesh;
    mesh.points = size*pointField
    ({
        point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0),
        point(0.3, 0.4, 0)
    });
    mesh.nBoundary = 5;
    mesh.faces = List<surfaceFace>
    ({
        {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}
    });
    return mesh;
}


//- Tension along x of a square stretched by l1 and l2 over the modulus; the
//  tension along y is set, too
scalar tension
(
    const string& law,
    const scalar l1,
    const scalar l2,
    scalar& other
)
{
    const scalar size = 1e-6;
    const sheetMaterial sheet(dictionaryOf(material(law)));
    const shapeMesh mesh(square(size));
    Eigen::MatrixXd x(5, 3), force;
    for (label i = 0; i < 5; ++i)
    {
        x.row(i) << l1*mesh.points[i].x(), l2*mesh.points[i].y(), 0;
    }
    membraneForces(sheet, mesh, size).energy(x, &force);
    other = -(force(2, 1) + force(3, 1))/(Gs*l1*size);
    EXPECT_NEAR(force.row(4).norm(), 0, 1e-10*Gs*size);
    EXPECT_NEAR(force.colwise().sum().norm(), 0, 1e-10*Gs*size);
    return -(force(1, 0) + force(2, 0))/(Gs*l2*size);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(membraneLaws, uniaxialTension)
{
    // Exact; digits of the table of Barthes-Biesel, Diaz & Dhenin 2002
    const struct { scalar l, neoHookean, Skalak; } rows[] =
    {
        {1.01, 0.02985, 0.03030}, {1.1, 0.28691, 0.33270},
        {1.5, 1.29279, 2.78730}, {2, 2.47487, 11.25486}
    };
    for (const auto& row : rows)
    {
        scalar other;
        EXPECT_NEAR
        (
            tension("law neoHookean;", row.l, 1/std::sqrt(row.l), other),
            row.neoHookean,
            1e-5
        );
        EXPECT_NEAR(other, 0, 1e-9);
        const scalar l2 = std::sqrt((1 + sqr(row.l))/(1 + pow4(row.l)));
        EXPECT_NEAR
        (
            tension("areaModulus 15e-6;", row.l, l2, other), row.Skalak, 1e-5
        );
        EXPECT_NEAR(other, 0, 1e-9);
    }
}


TEST(membraneLaws, modulusOfArea)
{
    // All-round tension K 2 (l - 1) of small strains
    const scalar l = 1.00001;
    scalar other;
    EXPECT_NEAR(tension("areaModulus 5e-4;", l, l, other), 2e-3, 2e-6);
    EXPECT_NEAR(tension("law neoHookean;", l, l, other), 6e-5, 1e-8);
}


TEST(membraneLaws, dropHasAConstantTension)
{
    const scalar size = 1e-3;
    const sheetMaterial sheet
    (
        dictionaryOf("type membrane; density 1; law drop; tension 0.03;")
    );
    const shapeMesh mesh(square(size));
    Eigen::MatrixXd x(5, 3), force;
    for (label i = 0; i < 5; ++i)
    {
        x.row(i) << 1.7*mesh.points[i].x(), 0.8*mesh.points[i].y(), 0;
    }
    const scalar energy = membraneForces(sheet, mesh, size).energy(x, &force);
    EXPECT_NEAR(energy, 0.03*1.7*0.8*sqr(size), 1e-20);
    EXPECT_NEAR(-(force(1, 0) + force(2, 0)), 0.03*0.8*size, 1e-15);
    EXPECT_NEAR(-(force(2, 1) + force(3, 1)), 0.03*1.7*size, 1e-15);
}


TEST(membraneLaws, principalStretches)
{
    const shapeMesh mesh(square(1e-6));
    pointField moved(mesh.points);
    for (point& p : moved)
    {
        p = cmptMultiply(p, vector(0.9, 1.3, 1));
    }
    const membraneTriangle t(mesh.faces[1], mesh.points);
    scalar larger, smaller;
    t.stretches(moved, larger, smaller);
    EXPECT_NEAR(larger, 1.3, 1e-12);
    EXPECT_NEAR(smaller, 0.9, 1e-12);
}


TEST(membraneLaws, largerTension)
{
    // Tension along one axis without tension across it (Barthes-Biesel et al.
    // 2002), of more triangles than are computed side by side
    scalarField stretches, hooke, across, narrow, skalak;
    for (scalar l = 1; l < 2; l += 0.1)
    {
        const scalar l4 = 1 + pow(l, 4);
        const scalar wide = (1 + sqr(l))/l4;
        stretches.append(l);
        hooke.append((pow(l, 3) - 1)/(l*std::sqrt(l)));
        across.append(1/std::sqrt(l));
        narrow.append(std::sqrt(wide));
        skalak.append(l*(sqr(l) - 1)*std::sqrt(wide)*(1/wide + 1/l4));
    }
    const auto tensions = [&](const string& law, const scalarField& others)
    {
        const sheetMaterial sheet(dictionaryOf(material(law)));
        return sheet.law->tensions(stretches, others);
    };
    const scalarField rubber(tensions("law neoHookean;", across));
    const scalarField skin(tensions("areaModulus 15e-6;", narrow));
    forAll(stretches, i)
    {
        EXPECT_NEAR(rubber[i], hooke[i], 1e-12) << stretches[i];
        EXPECT_NEAR(skin[i], skalak[i], 1e-10) << stretches[i];
    }
}


TEST(membraneLaws, wormLikeChainsShowTheirModuli)
{
    // Small strains of a mesh of equal triangles: T = K (e1 + e2) + G (e1 - e2)
    const scalar e = 1e-5;
    const sheetMaterial sheet
    (
        dictionaryOf(material("law wormLikeChain; areaModulus 25e-6;"))
    );
    const scalarField found
    (
        sheet.law->tensions
        (
            scalarList({1 + e, 1 + e, 1, 1}),
            scalarList({1 - e, 1 + e, 1, 1 + e})
        )
    );
    EXPECT_NEAR(found[0], 2*e, 1e-3*e);
    EXPECT_NEAR(found[1], 10*e, 1e-3*e);
    EXPECT_NEAR(found[2], 0, 1e-12);
    EXPECT_NEAR(found[3], 4*e, 1e-3*e);
    EXPECT_NEAR(sheet.law->areaModulus(), 5, 1e-12);

    // Edges near the largest length, and beyond it
    const scalarField large
    (
        sheet.law->tensions(scalarList({2, 2.45}), scalarList({1, 1}))
    );
    EXPECT_GT(large[1], 20*large[0]);
    const shapeMesh mesh(square(1));
    Eigen::MatrixXd x(5, 3);
    for (label i = 0; i < 5; ++i)
    {
        x.row(i) << 2.3*mesh.points[i].x(), mesh.points[i].y(), 0;
    }
    Eigen::MatrixXd force;
    EXPECT_THROW
    (
        membraneForces(sheet, mesh, 1).energy(x, &force), Foam::error
    );
}


TEST(membraneLaws, forcesOfWormLikeChainsAreTheGradientOfTheEnergy)
{
    const scalar size = 1e-6, h = 1e-6*size;
    const sheetMaterial sheet
    (
        dictionaryOf(material("law wormLikeChain; areaModulus 25e-6;"))
    );
    const shapeMesh mesh(square(size));
    const membraneForces forces(sheet, mesh, size);
    Eigen::MatrixXd x(5, 3), force;
    for (label i = 0; i < 5; ++i)
    {
        const point& p = mesh.points[i];
        x.row(i) << 1.3*p.x() + 0.1*p.y(), 0.9*p.y(), 0.2*p.x();
    }
    forces.energy(x, &force);
    for (label i = 0; i < x.size(); ++i)
    {
        Eigen::MatrixXd y(x);
        y(i) += h;
        const scalar after = forces.energy(y);
        y(i) -= 2*h;
        const scalar slope = (after - forces.energy(y))/(2*h);
        EXPECT_NEAR(force(i), -slope, 1e-6*Gs*size) << i;
    }
}


TEST(membraneLaws, badEntriesAreErrors)
{
    for
    (
        const char* entries :
        {
            "law rubber;", "law neoHookean; areaModulus 1;",
            "areaModulus 1e-6;", "law wormLikeChain; areaModulus 9e-6;",
            "law drop;",
            "stretchingModulus 1;", "restCurvature 3;",
            "bendingModulus -1;", "innerViscosity 0;"
        }
    )
    {
        const dictionary dict(dictionaryOf(material(entries)));
        EXPECT_THROW(sheetMaterial sheet(dict), Foam::IOerror) << entries;
    }
}


// ************************************************************************* //
