// SPDX-License-Identifier: GPL-3.0-or-later

#include "lawCases.H"

TEST(ContactLaw, pressureIsTheSlopeOfTheEnergy)
{
    for (const std::string& text : potentialLaws)
    {
        autoPtr<contactLaw> law(lawOf(text));
        const auto& p = dynamic_cast<const potentialContact&>(law());
        for (scalar gap = 0.0006; gap < 0.35; gap *= 1.07)
        {
            const scalar d = 1e-5*gap;
            const scalar scale = p.repulsion(gap) + 10;
            EXPECT_NEAR
            (
                p.pressure(gap),
                (p.energy(gap - d) - p.energy(gap + d))/(2*d),
                1e-6*scale
            ) << text << gap;
            if (gap < scales.range)
            {
                EXPECT_NEAR
                (
                    p.repulsionSlope(gap),
                    (p.repulsion(gap + d) - p.repulsion(gap - d))/(2*d),
                    1e-6*(mag(p.repulsionSlope(gap)) + scale/gap)
                ) << text << gap;
            }
        }
    }
}


TEST(ContactLaw, smoothAtTheRangeAndStrongAtContact)
{
    for (const std::string& text : potentialLaws)
    {
        autoPtr<contactLaw> law(lawOf(text));
        const auto& p = dynamic_cast<const potentialContact&>(law());
        const scalar range = scales.range;
        EXPECT_EQ(p.energy(range), 0);
        EXPECT_EQ(p.pressure(range), 0);
        EXPECT_NEAR(p.energy(0.9999*range), 0, 1e-4) << text;
        EXPECT_NEAR(p.pressure(0.9999*range), 0, 0.02) << text;
        EXPECT_GT(p.pressure(1e-3*range), 1e4) << text;
        EXPECT_GT(p.pressure(-0.1*range), p.pressure(1e-3*range)) << text;
    }
}


TEST(ContactLaw, adhesionHasItsMinimumAtTheEquilibriumGap)
{
    // Far from the cut-off, where the potential is that of the books
    const contactScales wide{0.1, 3, 50};
    autoPtr<contactLaw> law
    (
        contactLaw::New(dictOf("type Morse; adhesionEnergy 3;"), wide)
    );
    const auto& p = dynamic_cast<const potentialContact&>(law());
    EXPECT_NEAR(p.energy(0.1), -3, 0.01);
    EXPECT_NEAR(p.pressure(0.1), 0, 0.01);
    EXPECT_LT(p.pressure(0.15), -1);
    EXPECT_GT(p.pressure(0.07), 1);
}


TEST(ContactLaw, forcesAndMomentsBalance)
{
    for (const std::string& text : potentialLaws)
    {
        rigidBodies world(twoDiscs(37, 52, 0.1));
        contact law(dictOf("law {" + text + "}"), 2, 0.1, 50);
        world.advance(law, 0.01);

        scalar size = 0;
        vector moment(Zero);
        forAll(world.force, i)
        {
            size += mag(world.force[i]);
            moment += world.surfaces.points()[i] ^ world.force[i];
        }
        ASSERT_GT(size, 0.01);
        EXPECT_LT(mag(sum(world.force)), 1e-15*size);
        EXPECT_LT(mag(moment), 1e-14*size);
        EXPECT_EQ(world.statistics.contacts, 1);
        EXPECT_EQ(world.statistics.objectContacts[0], 1);
        EXPECT_NEAR(world.statistics.smallestGap, 0.1, 0.005);
    }
}


TEST(ContactLaw, nodeSpacingDoesNotMatter)
{
    // So short a step that positions and velocities hardly change
    vector coarse(Zero), fine(Zero);
    for (const label n : {60, 240})
    {
        rigidBodies world(twoDiscs(n, n, 0.12));
        contact law(dictOf(""), 2, 0.1, 50);
        world.advance(law, 1e-5);
        (n == 60 ? coarse : fine) = forceOn(world, 1);
    }
    EXPECT_GT(mag(fine), 0.1);
    EXPECT_LT(mag(coarse - fine), 0.05*mag(fine));
    EXPECT_GT(fine & vector(0.8, 0.6, 0), 0.999*mag(fine));
}


TEST(ContactLaw, sameInAMovingFrameAndInTheMirror)
{
    vector base(Zero), moving(Zero), mirrored(Zero);
    for (label variant = 0; variant < 3; ++variant)
    {
        rigidBodies world(twoDiscs(40, 40, 0.1));
        for (rigidBodies::solid& d : world.solids)
        {
            if (variant == 1)
            {
                d.velocity += vector(30, -20, 0);
            }
            if (variant == 2)
            {
                d.centre.x() *= -1;
                d.velocity.x() *= -1;
                d.spin *= -1;
            }
        }
        contact law(dictOf("law { tolerance 1e-14; }"), 2, 0.1, 50);
        world.advance(law, 0.01);
        (variant == 0 ? base : variant == 1 ? moving : mirrored) =
            forceOn(world, 0);
    }
    mirrored.x() *= -1;
    ASSERT_GT(mag(base), 0.1);
    EXPECT_LT(mag(moving - base), 1e-9*mag(base));
    EXPECT_LT(mag(mirrored - base), 1e-10*mag(base));
}


TEST(ContactLaw, noneCountsOnly)
{
    rigidBodies world(twoDiscs(60, 60, 0.1));
    contact law(dictOf("law { type none; }"), 2, 0.1, 50);
    world.advance(law, 0.01);
    EXPECT_EQ(sum(mag(world.force)), 0);
    EXPECT_EQ(world.statistics.contacts, 1);
}


TEST(ContactLaw, badInput)
{
    for
    (
        const char* text :
        {
            "type rubber;", "stifness 1;", "stiffness 0;", "stiffness -1;",
            "restitution 0;", "restitution 1.1;", "tolerance 0;",
            "type Morse;", "type Morse; adhesionEnergy 1; equilibriumGap 3;",
            "type LennardJones; adhesionEnergy 1;",
            "type thesis; restitution 1;", "type none; stiffness 1;"
        }
    )
    {
        EXPECT_THROW(lawOf(text), Foam::IOerror) << text;
    }
    for
    (
        const char* text :
        {"range 0;", "range 5e-7;", "gap 1;", "minimumGap -1;"}
    )
    {
        EXPECT_THROW(contact(dictOf(text), 2, 0.1, 50), Foam::IOerror) << text;
    }
    const char* adhesive = "law { type Morse; adhesionEnergy 1; }";
    EXPECT_THROW(contact(dictOf(adhesive), 2, 0.1, 0), Foam::IOerror);
}


// ************************************************************************* //
