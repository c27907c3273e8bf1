// SPDX-License-Identifier: GPL-3.0-or-later

#include "solidTables.H"
#include "samples/solidLoads.H"

#include <cstdio>

using namespace solidSamples;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar E = 1e4;

//- Names and entries of the materials
const std::pair<word, string> materials[] =
{
    {"element", "type neoHookean; strain element;"},
    {"nodalVolume", "type neoHookean; strain nodalVolume;"},
    {"smoothed", "type neoHookean; strain smoothed;"},
    {"springs", "type elastic; strain nodalVolume;"}
};


//- Entries of a material with its bulk modulus
string materialOf(const string& entries, const scalar bulkModulus)
{
    return
        entries + " density 1000; E " + name(E) + "; areaStiffness "
      + name(2*bulkModulus) + ";";
}


void printLocking()
{
    std::puts("strain,K/E,nodes at 8 h,8 h,nodes at 12 h,12 h");
    for (const auto& material : materials)
    {
        for (const scalar K : {1.0/3, 2.0, 10.0, 100.0})
        {
            // Springs have a bulk modulus of their own
            if (material.first == "springs" && K < 1)
            {
                continue;
            }
            std::printf("%s,%.3g", material.first.c_str(), K);
            for (const label across : {8, 12})
            {
                const auto shape =
                    sphere(across, materialOf(material.second, K*E));
                std::printf
                (
                    ",%d,%.3f", int(shape->nNodes()), sphereCompliance(*shape)
                );
            }
            std::puts("");
            std::fflush(stdout);
        }
    }
}


void printBending()
{
    std::puts("strain,K/E,3 nodes,5 nodes,9 nodes");
    for (const auto& material : materials)
    {
        for (const scalar K : {1.0, 5.0, 50.0})
        {
            std::printf("%s,%.3g", material.first.c_str(), K);
            for (const label n : {2, 4, 8})
            {
                std::printf
                (
                    ",%.3f",
                    bendingCompliance(n, materialOf(material.second, K*E))
                );
                std::fflush(stdout);
            }
            std::puts("");
        }
    }
}


//- Velocities of a bar of 4 x 4 x 12 spacings after a step
Eigen::MatrixXd step
(
    const string& material,
    const string& admm,
    const scalar reach
)
{
    const scalar side = 0.1;
    const auto shape = solidOf
    (
        uneven(centredBox(4, 4, 12, side), side, 0.1), side, material, admm
    );
    copies body(*shape);
    body.deform(Eigen::Vector3d(1.1, 1.05, 0.9).asDiagonal());
    return body.predicted
    (
        reach*side/std::sqrt(E/1000),
        unevenForce(body, 0.02*E*sqr(side))
    );
}


void printIterations()
{
    std::puts("material,scheme,iterations,reach 0.2,reach 0.7,reach 3");
    for (const label m : {1, 3})
    {
        const string material(materialOf(materials[m].second, 5*E));
        const scalar reaches[] = {0.2, 0.7, 3};
        Eigen::MatrixXd exact[3];
        for (label i = 0; i < 3; ++i)
        {
            exact[i] =
                step(material, "iterations 9000; tolerance 1e-12;", reaches[i]);
        }
        for (const word scheme : {"quasiNewton", "ADMM"})
        {
            for (const label iterations : {1, 4, 8, 12, 20, 40})
            {
                std::printf
                (
                    "%s,%s,%d",
                    materials[m].first.c_str(), scheme.c_str(), int(iterations)
                );
                for (label i = 0; i < 3; ++i)
                {
                    const Eigen::MatrixXd v = step
                    (
                        material,
                        "scheme " + scheme
                      + "; iterations " + name(iterations) + ";",
                        reaches[i]
                    );
                    std::printf
                    (
                        ",%.1e",
                        (v - exact[i]).cwiseAbs().maxCoeff()
                       /exact[i].cwiseAbs().maxCoeff()
                    );
                }
                std::puts("");
                std::fflush(stdout);
            }
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void solidTables::print(const word& table)
{
    if (table == "locking")
    {
        printLocking();
    }
    else if (table == "bending")
    {
        printBending();
    }
    else
    {
        printIterations();
    }
}


// ************************************************************************* //
