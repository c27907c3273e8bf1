// SPDX-License-Identifier: GPL-3.0-or-later

#include "mathematicalConstants.H"
#include "membraneForces.H"
#include "membraneViscosity.H"
#include "samples/outlines.H"
#include "samples/samples.H"

#include <gtest/gtest.h>

#include <random>

using namespace samples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar pi = constant::mathematical::pi;
const scalar Gs = 5e-6;
const scalar radius = 4e-6;
const scalar depth = 0.3e-6;
const scalar unit = 0.5e-6;


sheetMaterial materialOf(const string& others)
{
    return sheetMaterial
    (
        dictionaryOf
        (
            "type membrane; density 1000; shearModulus 5e-6; " + others
        ),
        2
    );
}


Eigen::MatrixXd places(const shapeMesh& mesh, const scalar factor)
{
    Eigen::MatrixXd x(mesh.points.size(), 2);
    forAll(mesh.points, i)
    {
        x.row(i) << factor*mesh.points[i].x(), factor*mesh.points[i].y();
    }
    return x;
}


//- Tension of a ring whose nodes are pushed inwards by these forces
scalar tensionOf(const Eigen::MatrixXd& force)
{
    const label n = force.rows();
    return -force(0, 0)/(2*std::sin(pi/n)*depth);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(membraneLines, haveTheTensionOfASheetThatIsHeldAlongZ)
{
    const shapeMesh mesh(ring(radius, 40));
    const auto tension = [&](const string& law, const scalar l)
    {
        const sheetMaterial material(materialOf(law));
        Eigen::MatrixXd force;
        membraneForces(material, mesh, unit, depth).energy
        (
            places(mesh, l), &force
        );
        EXPECT_LT(force.colwise().sum().norm(), 1e-12*force.norm());
        const scalar T = tensionOf(force);
        EXPECT_NEAR
        (
            material.law->tensions(scalarList({l}), scalarList({1}))[0],
            T/Gs,
            1e-9*mag(T/Gs) + 1e-12
        );
        return T/Gs;
    };
    for (const scalar l : {0.8, 1.0, 1.01, 1.1, 1.5, 2.0})
    {
        // W = (1 + C)/4 (l^2 - 1)^2, C = 4; W = (l^2 + 1/l^2 - 2)/2
        EXPECT_NEAR
        (
            tension("areaModulus 45e-6;", l), 5*l*(sqr(l) - 1), 1e-9
        );
        EXPECT_NEAR(tension("law neoHookean;", l), l - 1/pow3(l), 1e-9);
    }
}


TEST(membraneLines, bendingEnergyOfARing)
{
    // kappa/2 over the square of the radius
    const shapeMesh mesh(ring(radius, 60));
    const scalar kappa = 2e-19;
    const auto energy = [&](const string& rest)
    {
        const sheetMaterial material
        (
            materialOf("bendingModulus 2e-19;" + rest)
        );
        return membraneForces(material, mesh, unit, depth).energy
        (
            places(mesh, 1)
        );
    };
    const scalar expected = pi*kappa*depth/radius;
    EXPECT_NEAR(energy("restCurvature flat;"), expected, 2e-3*expected);
    EXPECT_NEAR(energy(""), 0, 1e-12*expected);
}


TEST(membraneLines, forceIsMinusTheSlopeOfTheEnergy)
{
    // Nine copies: a full set of lanes and one lane of the next
    const shapeMesh mesh
    (
        outline
        (
            23, [](const scalar a) { return radius*(1 + 0.3*std::cos(2*a)); }
        )
    );
    for (const char* law : {"", "law neoHookean;"})
    {
        const sheetMaterial material
        (
            materialOf(string(law) + "bendingModulus 2e-18;")
        );
        const membraneForces forces(material, mesh, unit, depth);
        std::mt19937 random(5);
        std::uniform_real_distribution<scalar> shift(-0.05*unit, 0.05*unit);
        Eigen::MatrixXd x(23, 18);
        for (label copyi = 0; copyi < 9; ++copyi)
        {
            x.middleCols(2*copyi, 2) = places(mesh, 1 + 0.02*copyi);
        }
        x = x.unaryExpr([&](const scalar v) { return v + shift(random); });
        Eigen::MatrixXd force;
        forces.energy(x, &force);
        for (Eigen::Index i = 0; i < x.size(); i += 7)
        {
            const scalar step = 1e-5*unit, middle = x(i);
            x(i) = middle + step;
            const scalar above = forces.energy(x);
            x(i) = middle - step;
            const scalar below = forces.energy(x);
            x(i) = middle;
            EXPECT_NEAR
            (
                force(i),
                (below - above)/(2*step),
                1e-5*force.cwiseAbs().maxCoeff()
            );
        }
    }
}


TEST(membraneLines, steadyStrainTakesThePowerOfTheViscosity)
{
    // 2 mu_m dev(D) is mu_m times the rate of the strain along the line
    const scalar viscosity = 1e-7;
    const sheetMaterial material
    (
        materialOf("membraneViscosity 1e-7; viscousModulus 1e-4;")
    );
    const shapeMesh mesh(ring(radius, 30));
    membraneViscosity sheet(material, mesh, depth);
    sheet.resize(1);
    sheet.start(0);
    const scalar dt = 1e-4, rate = 0.05;
    scalar size = 1;
    for (label step = 0; step < 200; ++step)
    {
        size *= 1 + dt*rate;
        sheet.relax(dt, places(mesh, size));
    }
    Eigen::MatrixXd force(Eigen::MatrixXd::Zero(30, 2));
    sheet.addForce(places(mesh, size), force);
    EXPECT_NEAR(tensionOf(force), viscosity*rate, 3e-3*viscosity*rate);
}


TEST(membraneLines, worksWithLawsOfSheetsOnly)
{
    EXPECT_THROW(materialOf("law wormLikeChain;"), Foam::IOerror);
    EXPECT_NO_THROW(materialOf("law neoHookean;"));
}


// ************************************************************************* //
